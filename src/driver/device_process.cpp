#include "limber/driver/device_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/standard_streams.hpp"
#include "limber/driver/line_reader.hpp"

namespace limber {

namespace {

using Clock = LineReader::Clock;

constexpr auto kSilence = std::chrono::milliseconds(200);
constexpr std::size_t kMaxLine = 65536;

/// One line of the log: `fields` and the monotonic clock's time.
void log_line(int log, const std::string& fields) {
  const double now_s = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
  const std::string text = fmt::format("{{\"at_s\": {:.6f}, {}}}\n", now_s, fields);
  (void)!::write(log, text.data(), text.size());
}

/// What the board does until its line goes dead. A line that begins with "set" opens its valves.
void run_device(int line_end, int log) {
  LineReader input(line_end, kMaxLine);
  std::string line;
  bool open = false;
  for (;;) {
    const auto deadline = open ? Clock::now() + kSilence : Clock::now() + std::chrono::hours(1);
    const LineReader::Read read = input.read_line(line, deadline);
    if (read == LineReader::Read::line) {
      open = line.starts_with("\"set\"") || (open && line.starts_with("\"fault\""));
      log_line(log, "\"event\": " + line);
    } else if (read == LineReader::Read::timeout && open) {
      open = false;
      log_line(log, "\"event\": \"vent\", \"why\": \"no command for 0.2 s\"");
    } else if (read != LineReader::Read::timeout) {
      log_line(log, "\"event\": \"vent\", \"why\": \"the driver is gone\"");
      return;
    }
  }
}

[[noreturn]] void be_the_device(int line_end, int log) {
  ::setsid();  // a board is in nobody's process group …
  const sched_param priority{.sched_priority = 1};
  (void)::sched_setscheduler(0, SCHED_FIFO, &priority);  // … and, where allowed, waits for no one
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGTSTP}) {
    std::signal(number, SIG_IGN);
  }
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::dup2(nothing, stream);
  }
  run_device(line_end, log);
  ::_exit(0);
}

[[noreturn]] void refuse(const std::string& what) {
  throw SystemFault(fmt::format("{}: {}", what, std::generic_category().message(errno)));
}

}  // namespace

DeviceProcess::DeviceProcess(const fs::path& log) {
  if (log.empty()) {
    return;
  }
  const int file =
      ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644);  // NOLINT
  if (file < 0) {
    refuse(log.string());
  }
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    ::close(file);
    refuse("simulated device");
  }
  process_ = ::fork();
  if (process_ == 0) {
    ::close(ends[1]);
    be_the_device(ends[0], file);
  }
  ::close(ends[0]);
  ::close(file);
  line_ = ends[1];
  if (process_ < 0) {
    refuse("simulated device");
  }
}

DeviceProcess::~DeviceProcess() {
  if (line_ >= 0) {
    ::close(line_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

void DeviceProcess::set(const Pressures& setpoint_kpa) {
  tell(fmt::format("\"set\", \"pressure_kpa\": [{}]", fmt::join(setpoint_kpa, ", ")));
}

void DeviceProcess::vent(std::string_view why) {
  tell(fmt::format("\"vent\", \"why\": \"{}\"", why));
}

void DeviceProcess::note(std::string_view kind, int frame) {
  tell(fmt::format("\"fault\", \"kind\": \"{}\", \"frame\": {}", kind, frame));
}

void DeviceProcess::tell(const std::string& line) {
  if (line_ < 0) {
    return;
  }
  const std::string text = line + "\n";
  WithoutBrokenPipe guard;
  if (::write(line_, text.data(), text.size()) < 0) {
    guard.note(errno);
  }
}

}  // namespace limber
