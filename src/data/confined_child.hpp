#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace limber {

/// What a confined child may use.
struct ChildLimits {
  std::uintmax_t memory_bytes = 0;  ///< beyond what the process has when it starts
  unsigned cpu_s = 0;
};

/// What `receive` below throws where the pipe ends before all that it expects has come.
struct EndOfPipe {
  bool silent = false;  ///< the child still runs, but has sent nothing for long
};

/// Runs `work` in a copy of this process that can compute and write to the pipe that `work` is
/// given, and nothing else: it opens no file, socket or program, reaches no other process, keeps no
/// open file of this one, and ends with this thread. Meanwhile `receive` reads the other end here.
/// What either throws ends both; `work` tells of its own failures through the pipe.
/// @param name  of the file that is read: what every message begins with
/// @throws InputError where the child crashes, or needs more than its limits; SystemFault where the
/// machine gives no child
void run_confined(const std::string& name, const ChildLimits& limits,
                  const std::function<void(int pipe)>& work,
                  const std::function<void(int pipe)>& receive);

}  // namespace limber
