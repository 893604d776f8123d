#include "punctual_thread.hpp"

#include <unistd.h>

namespace limber {

namespace {

constexpr int kPriority = 10;  // above every ordinary thread, below the kernel's own and audio's

}  // namespace

PunctualThread::PunctualThread() : thread_(gettid()), policy_before_(sched_getscheduler(thread_)) {
  if ((policy_before_ & ~SCHED_RESET_ON_FORK) != SCHED_OTHER ||
      sched_getparam(thread_, &priority_before_) != 0) {
    return;  // somebody has chosen already
  }
  sched_param priority = {};
  priority.sched_priority = kPriority;
  is_raised_ = sched_setscheduler(thread_, SCHED_RR | SCHED_RESET_ON_FORK, &priority) == 0;
}

PunctualThread::~PunctualThread() {
  if (is_raised_) {
    // Clearing "reset on fork" needs a privilege that setting it does not; it harms nobody.
    (void)sched_setscheduler(thread_, policy_before_ | SCHED_RESET_ON_FORK, &priority_before_);
  }
}

}  // namespace limber
