#pragma once
// For everyone.

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace limber {

/// Progress of one long task on standard error: on a terminal a bar with rate and time left,
/// otherwise an occasional line, nothing when quiet.
///
/// Threads: `advance` and `update` may be called from several at once.
class Progress {
 public:
  enum class Mode { automatic, quiet };

  /// @param total  units of work, 0 if unknown.
  Progress(std::string task, std::string unit, std::uint64_t total, Mode mode = Mode::automatic);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::uint64_t units = 1);

  /// Sets the work done so far and a note shown behind the bar ("loss 0.12").
  void update(std::uint64_t done, const std::string& note = {});

  /// Prints the last state and ends the line; the destructor calls it.
  void finish();

 private:
  void print(bool last);

  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  std::string task_;
  std::string unit_;
  std::string note_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  bool quiet_;
  bool terminal_;
  bool finished_ = false;
  Clock::time_point start_;
  Clock::time_point last_print_;
};

/// "1:05" or "2:03:10"; "0:07" under a minute.
std::string format_duration(double seconds);

}  // namespace limber
