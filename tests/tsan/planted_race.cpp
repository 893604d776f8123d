// A loop whose bodies count: `race` in one number, `no_race` each in its thread's own.

#include <cstring>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "kernels/job_arena.hpp"

int main(int, char** arguments) {
  const bool race = std::strcmp(arguments[1], "race") == 0;
  int count = 0;
  tbb::enumerable_thread_specific<int> counts;
  limber::JobArena arena(2);
  arena.execute(
      [&] { tbb::parallel_for(0, 100, [&](int) { ++(race ? count : counts.local()); }); });
  return 0;
}
