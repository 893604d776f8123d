#pragma once

#include <signal.h>

namespace limber {

/// Keeps SIGPIPE from ending the process while this thread writes to a pipe that nobody may read.
class WithoutBrokenPipe {
 public:
  WithoutBrokenPipe();
  ~WithoutBrokenPipe();
  WithoutBrokenPipe(const WithoutBrokenPipe&) = delete;
  WithoutBrokenPipe& operator=(const WithoutBrokenPipe&) = delete;

  /// To be told the errno of every write that failed.
  void note(int error);

 private:
  sigset_t signal_{};
  sigset_t before_{};
  bool was_pending_ = false;
  bool broken_ = false;
};

}  // namespace limber
