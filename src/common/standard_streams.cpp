#include "limber/common/standard_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstddef>
#include <ctime>

#include "limber/common/descriptor.hpp"

namespace limber {

namespace {

using Clock = std::chrono::steady_clock;

/// For a reader that is slower than somebody writes.
constexpr auto kPatience = std::chrono::milliseconds(20);

/// Whether nobody read the last message in that time. Then the next ones are not waited for.
std::atomic<bool> is_stuck{false};

bool is_writable(int timeout_ms) {
  pollfd stream{STDERR_FILENO, POLLOUT, 0};
  return ::poll(&stream, 1, timeout_ms) > 0;
}

/// Standard error without O_NONBLOCK on what others share: its pipe or terminal is opened once
/// more. Where that is not allowed, only what poll() promises is written.
class StandardError {
 public:
  StandardError() {
    struct stat status {};
    if (::fstat(STDERR_FILENO, &status) == 0) {
      is_socket_ = S_ISSOCK(status.st_mode);
      can_block_ = S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode);
    }
    if (can_block_) {
      own_ = Descriptor(::open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    }
  }

  /// As write(), but never waits: EAGAIN.
  ssize_t write(std::string_view text) const {
    if (is_socket_) {
      return ::send(STDERR_FILENO, text.data(), text.size(), MSG_DONTWAIT);
    }
    if (own_.is_open() || !can_block_) {
      return ::write(own_.is_open() ? own_.get() : STDERR_FILENO, text.data(), text.size());
    }
    if (!is_writable(0)) {
      errno = EAGAIN;
      return -1;
    }
    return ::write(STDERR_FILENO, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
  }

 private:
  Descriptor own_;
  bool is_socket_ = false;
  bool can_block_ = false;
};

}  // namespace

void print_to_stderr(std::string_view text) noexcept {
  WithoutBrokenPipe guard;
  const StandardError stream;
  const Clock::time_point deadline = Clock::now() + (is_stuck ? kPatience * 0 : kPatience);
  while (!text.empty()) {
    const ssize_t written = stream.write(text);
    if (written >= 0) {
      text.remove_prefix(std::size_t(written));
    } else if (errno == EAGAIN && Clock::now() < deadline) {
      (void)is_writable(1);
    } else if (errno != EINTR) {
      guard.note(errno);
      is_stuck = errno == EAGAIN;
      return;
    }
  }
  is_stuck = false;
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
