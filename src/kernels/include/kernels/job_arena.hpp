#pragma once

#include <algorithm>
#include <cstddef>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace limber {

/// `--jobs`: a oneTBB arena of that many threads, 0 for one per core, more than there are cores
/// where that is asked for.
class JobArena {
 public:
  explicit JobArena(int jobs)
      : allowance_(tbb::global_control::max_allowed_parallelism,
                   std::size_t(std::max(count(jobs), count(0)))),
        arena_(count(jobs)) {}

  int jobs() const { return arena_.max_concurrency(); }

  /// body(i) for each i < n, in any order. @param partitioner  one of oneTBB's; usually none
  template <class Body, class... Partitioner>
  void for_each(std::size_t n, const Body& body, const Partitioner&... partitioner) {
    arena_.execute([&] { tbb::parallel_for(std::size_t{0}, n, body, partitioner...); });
  }

 private:
  static int count(int jobs) { return jobs > 0 ? jobs : tbb::info::default_concurrency(); }

  tbb::global_control allowance_;  // oneTBB would hold more jobs than cores back, with a warning
  tbb::task_arena arena_;
};

}  // namespace limber
