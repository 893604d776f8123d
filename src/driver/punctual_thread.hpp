#pragma once

#include <sched.h>
#include <sys/types.h>

namespace limber {

/// While it lives, the thread that made it goes before every other program's, where the system
/// allows that (root, or a limit `rtprio` for the user): set points then leave in time on a busy
/// machine too. Threads and processes that it starts do not inherit it. Where it is not allowed,
/// nothing changes.
///
/// May end on another thread than it began on.
class PunctualThread {
 public:
  PunctualThread();
  ~PunctualThread();
  PunctualThread(const PunctualThread&) = delete;
  PunctualThread& operator=(const PunctualThread&) = delete;

 private:
  pid_t thread_;
  int policy_before_;
  sched_param priority_before_ = {};
  bool is_raised_ = false;
};

}  // namespace limber
