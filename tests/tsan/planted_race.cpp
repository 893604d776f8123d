// A loop whose bodies count: `race` in one number, `no_race` each in its thread's own.

#include <cstring>

#include <tbb/enumerable_thread_specific.h>

#include "kernels/job_arena.hpp"

int main(int, char** arguments) {
  const bool race = std::strcmp(arguments[1], "race") == 0;
  int count = 0;
  tbb::enumerable_thread_specific<int> counts;
  limber::JobArena arena(2);
  arena.for_each(100, [&](std::size_t) { ++(race ? count : counts.local()); });
  return 0;
}
