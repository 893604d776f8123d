#include "limber/common/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

#include "limber/common/broken_pipe.hpp"

namespace limber {

void print_to_stderr(std::string_view text) noexcept {
  WithoutBrokenPipe guard;
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      guard.note(errno);
      return;
    }
  }
}

void open_missing_standard_streams() noexcept {
  int opened = STDIN_FILENO;
  // The lowest free number is given first: each open() fills one of the three, until none is free.
  while (opened >= 0 && opened <= STDERR_FILENO) {
    opened = ::open("/dev/null", O_RDWR);
  }
  if (opened > STDERR_FILENO) {
    ::close(opened);
  }
}

}  // namespace limber
