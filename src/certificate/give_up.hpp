#pragma once

#include <functional>

namespace limber {

/// Calls `ask` at some of the many times that it is called itself; once `ask` has said to give up,
/// the answer stays true.
class GiveUp {
 public:
  /// @param ask  borrowed; may be empty: never
  explicit GiveUp(const std::function<bool()>& ask) : ask_(ask) {}

  /// Cheap enough for the innermost loops, whose rounds take some microseconds at most.
  bool seldom() { return ++rounds_ % kRoundsPerQuestion == 0 ? now() : is_given_up_; }

  bool now() {
    is_given_up_ = is_given_up_ || (ask_ && ask_());
    return is_given_up_;
  }

  void give_up() { is_given_up_ = true; }
  bool is_given_up() const { return is_given_up_; }

 private:
  static constexpr unsigned kRoundsPerQuestion = 64;
  const std::function<bool()>& ask_;
  unsigned rounds_ = 0;
  bool is_given_up_ = false;
};

}  // namespace limber
