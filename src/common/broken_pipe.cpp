#include "limber/common/broken_pipe.hpp"

#include <pthread.h>

#include <cerrno>
#include <ctime>

namespace limber {

WithoutBrokenPipe::WithoutBrokenPipe() {
  sigemptyset(&signal_);
  sigaddset(&signal_, SIGPIPE);
  sigset_t pending;
  sigpending(&pending);
  was_pending_ = sigismember(&pending, SIGPIPE) == 1;
  pthread_sigmask(SIG_BLOCK, &signal_, &before_);
}

WithoutBrokenPipe::~WithoutBrokenPipe() {
  const timespec at_once{};
  // The kernel sends it to the thread that wrote, before write() returns.
  while (broken_ && !was_pending_ && sigtimedwait(&signal_, nullptr, &at_once) < 0 &&
         errno == EINTR) {
  }
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void WithoutBrokenPipe::note(int error) {
  broken_ = broken_ || error == EPIPE;
}

}  // namespace limber
