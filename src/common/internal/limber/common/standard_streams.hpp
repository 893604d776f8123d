#pragma once

#include <signal.h>
#include <string_view>

namespace limber {

/// Writes `text` to standard error as it is. Messages never affect the work: if standard error is
/// closed or full, or nobody reads it, they are lost, and nothing waits for longer than 20 ms.
/// Threads: any; safe in signal handlers.
void print_to_stderr(std::string_view text) noexcept;

/// Opens /dev/null in place of standard streams that are closed. Otherwise a file that is opened
/// later would get their number and the messages. Call this before anything else.
void open_missing_standard_streams() noexcept;

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
