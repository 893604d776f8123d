#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <utility>

namespace limber {

/// One of a controller's questions at a time. In real time it is worked out on a thread of its own,
/// so that no set point waits for it; in simulated time at once, so that runs can be repeated.
///
/// Threads: used by one. The destructor waits for the other, if there is one.
class BackgroundQuestion {
 public:
  explicit BackgroundQuestion(bool in_real_time) : in_real_time_(in_real_time) {}

  /// @pre the one before was answered
  void begin(std::function<void()> question) {
    if (in_real_time_) {
      answered_ = std::async(std::launch::async, std::move(question));
    } else {
      question();
    }
  }

  /// Whether it is still being worked out.
  bool is_busy() const {
    return answered_.valid() &&
           answered_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }

  /// Of one that is not busy: throws what it threw, once.
  void end() {
    if (answered_.valid()) {
      answered_.get();
    }
  }

 private:
  bool in_real_time_;
  std::future<void> answered_;
};

}  // namespace limber
