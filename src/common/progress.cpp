#include "limber/common/progress.hpp"

#include <unistd.h>

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/printable.hpp"
#include "limber/common/standard_streams.hpp"

namespace limber {

namespace {

constexpr int kBarWidth = 24;
constexpr double kTerminalInterval_s = 0.1;
constexpr double kLogInterval_s = 10.0;

std::string bar(double fraction) {
  const int filled = int(fraction * kBarWidth);
  return std::string(std::size_t(filled), '#') + std::string(std::size_t(kBarWidth - filled), '.');
}

}  // namespace

std::string format_duration(double seconds) {
  const auto whole = static_cast<long>(std::max(0.0, seconds) + 0.5);
  if (whole >= 3600) {
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  }
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Progress::Progress(std::string task, std::string unit, std::uint64_t total, Mode mode)
    : task_(std::move(task)),
      unit_(std::move(unit)),
      total_(total),
      quiet_(mode == Mode::quiet),
      terminal_(::isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      last_print_(start_) {}

Progress::~Progress() {
  finish();
}

void Progress::advance(std::uint64_t units) {
  const std::lock_guard lock(mutex_);
  done_ += units;
  print(false);
}

void Progress::update(std::uint64_t done, const std::string& note) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  note_ = note;
  print(false);
}

void Progress::finish() {
  const std::lock_guard lock(mutex_);
  if (!finished_) {
    finished_ = true;
    print(true);
  }
}

void Progress::print(bool last) {
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> since_print = now - last_print_;
  if (quiet_ ||
      (!last && since_print.count() < (terminal_ ? kTerminalInterval_s : kLogInterval_s))) {
    return;
  }
  last_print_ = now;
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const double rate = elapsed_s > 0.0 ? double(done_) / elapsed_s : 0.0;

  std::string line = terminal_ ? "\r" : "";
  line += printable(task_);
  if (total_ > 0) {
    const double fraction = std::min(1.0, double(done_) / double(total_));
    line += terminal_ ? fmt::format(" [{}]", bar(fraction)) : std::string();
    line += fmt::format(" {}/{} {}", done_, total_, unit_);
  } else {
    line += fmt::format(" {} {}", done_, unit_);
  }
  line += fmt::format(", {:.3g}/s", rate);
  if (last) {
    line += fmt::format(", took {}", format_duration(elapsed_s));
  } else if (total_ > done_ && rate > 0.0) {
    line += fmt::format(", {} left", format_duration(double(total_ - done_) / rate));
  }
  line += note_.empty() ? std::string() : ", " + printable(note_);
  line += terminal_ ? (last ? "\x1b[K\n" : "\x1b[K") : "\n";
  print_to_stderr(line);
}

}  // namespace limber
