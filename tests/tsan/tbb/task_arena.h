// How many threads the loops of an arena have, and which of them this thread is: oneTBB's names for
// what limber uses, in the preset tsan (tests/tsan/CMakeLists.txt).
#pragma once

#include "info.h"

namespace tbb {

namespace stand_in {

/// Where a thread runs.
struct Place {
  int threads = info::default_concurrency();  // of a loop that it starts
  int index = 0;                              // 0 ≤ index < threads
  bool in_team = false;  // of a loop's several threads: its own loops run in it alone
};

inline thread_local Place place;

class PlaceScope {
 public:
  explicit PlaceScope(const Place& inside) { place = inside; }
  ~PlaceScope() { place = outside_; }
  PlaceScope(const PlaceScope&) = delete;
  PlaceScope& operator=(const PlaceScope&) = delete;

 private:
  Place outside_ = place;
};

}  // namespace stand_in

class task_arena {
 public:
  static constexpr int automatic = -1;

  explicit task_arena(int threads = automatic)
      : threads_(threads == automatic ? info::default_concurrency() : threads) {}

  int max_concurrency() const { return threads_; }

  template <class Work>
  auto execute(Work&& work) {
    const stand_in::PlaceScope scope({threads_, 0, stand_in::place.in_team});
    return work();
  }

 private:
  int threads_;
};

namespace this_task_arena {
inline int current_thread_index() {
  return stand_in::place.index;
}
}  // namespace this_task_arena

}  // namespace tbb
