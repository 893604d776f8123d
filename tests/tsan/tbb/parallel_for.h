#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <latch>
#include <thread>
#include <vector>

#include "task_arena.h"

namespace tbb {

namespace stand_in {
inline constexpr std::size_t kMaxThreads = 16;  // of a loop, however many are asked for
}

struct simple_partitioner {};

/// body(first) … body(last − 1), by threads that start with the loop and end with it. Thread t of n
/// has the items t, t + n, …: were they handed out as asked for, the first thread would do all of a
/// short loop, and race with nobody. Only the start and the end put the threads in an order.
///
/// The first exception, by thread, is thrown again; the others end after their present item.
template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body, simple_partitioner = {}) {
  if (first >= last) {
    return;
  }
  const stand_in::Place outside = stand_in::place;
  const auto items = static_cast<std::size_t>(last - first);
  const std::size_t threads =
      std::min({static_cast<std::size_t>(outside.threads), items, stand_in::kMaxThreads});
  if (threads == 1 || outside.in_team) {
    for (Index i = first; i < last; ++i) {
      body(i);
    }
    return;
  }
  std::latch all_are_here(static_cast<std::ptrdiff_t>(threads));
  std::atomic<bool> failed = false;
  std::vector<std::exception_ptr> faults(threads);
  const auto run_share = [&](std::size_t thread) {
    const stand_in::PlaceScope scope({outside.threads, static_cast<int>(thread), true});
    all_are_here.arrive_and_wait();
    try {
      for (std::size_t item = thread; item < items && !failed.load(std::memory_order_relaxed);
           item += threads) {
        body(first + static_cast<Index>(item));
      }
    } catch (...) {
      faults[thread] = std::current_exception();
      failed.store(true, std::memory_order_relaxed);
    }
  };
  {
    std::vector<std::jthread> team;
    for (std::size_t thread = 1; thread < threads; ++thread) {
      team.emplace_back(run_share, thread);
    }
    run_share(0);
  }
  for (const std::exception_ptr& fault : faults) {
    if (fault) {
      std::rethrow_exception(fault);
    }
  }
}

}  // namespace tbb
