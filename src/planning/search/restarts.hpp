#pragma once

#include <cstdint>

namespace limber {

/// When a search that has found nothing starts again. Some searches find a plan soon and others
/// never, though they differ in their random numbers alone: their trees fill the cells that lead to
/// the goal with states from which it can't be reached. Lengths are those of Luby, Sinclair and
/// Zuckerman (1993), 1 1 2 1 1 2 4 …, whose expected time is within a factor of the logarithm of
/// the best schedule's, whatever the search.
class Restarts {
 public:
  /// @param unit_queries  of the model, for the shortest search; > 0
  explicit Restarts(double unit_queries) : unit_queries_(unit_queries) {}

  /// Whether the search that began at `begun_` has had its queries.
  bool is_due(std::uint64_t queries) const {
    return static_cast<double>(queries - begun_) >= unit_queries_ * length(count_ + 1);
  }
  /// The next search begins.
  void begin(std::uint64_t queries) {
    begun_ = queries;
    ++count_;
  }

  /// Term i ≥ 1 of the sequence.
  static double length(std::uint64_t i);

 private:
  double unit_queries_;
  std::uint64_t begun_ = 0;
  std::uint64_t count_ = 0;  // of searches that have ended
};

}  // namespace limber
