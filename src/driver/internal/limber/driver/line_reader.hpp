#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace limber {

/// Lines from a pipe, of bounded length and with deadlines. Threads: one at a time.
class LineReader {
 public:
  using Clock = std::chrono::steady_clock;

  enum class Read {
    line,      ///< one line was read
    timeout,   ///< none is there yet
    end,       ///< the other side has closed the pipe
    too_long,  ///< the line has more than `max_line` bytes
  };

  /// Takes over `descriptor` and closes it in the end.
  LineReader(int descriptor, std::size_t max_line);
  ~LineReader();
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

  /// The next line, without its end, in `line`.
  Read read_line(std::string& line, Clock::time_point deadline);

  /// Waits for bytes until `deadline`. @return whether there are any, or the pipe was closed.
  bool has_input(Clock::time_point deadline) const;

  bool has_part_of_line() const { return !buffer_.empty(); }

 private:
  bool take_line(std::string& line);

  int descriptor_;
  std::size_t max_line_;
  std::string buffer_;
  std::size_t searched_ = 0;  // bytes of the buffer that hold no end of line
};

/// Waits until `descriptor` is ready for `events` of poll(), or has an error.
/// @return whether it is.
bool wait_for_descriptor(int descriptor, short events, LineReader::Clock::time_point deadline);

}  // namespace limber
