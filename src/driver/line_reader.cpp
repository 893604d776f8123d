#include "limber/driver/line_reader.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <ctime>

namespace limber {

LineReader::LineReader(int descriptor, std::size_t max_line)
    : descriptor_(descriptor), max_line_(max_line) {}

LineReader::~LineReader() {
  ::close(descriptor_);
}

bool LineReader::take_line(std::string& line) {
  const std::size_t end = buffer_.find('\n', searched_);
  if (end == std::string::npos) {
    searched_ = buffer_.size();
    return false;
  }
  line.assign(buffer_, 0, end);
  buffer_.erase(0, end + 1);
  searched_ = 0;
  return true;
}

LineReader::Read LineReader::read_line(std::string& line, Clock::time_point deadline) {
  constexpr std::size_t kChunk = 65536;
  std::array<char, kChunk> chunk;
  while (!take_line(line)) {
    if (buffer_.size() > max_line_) {
      return Read::too_long;
    }
    if (!wait_for_descriptor(descriptor_, POLLIN, deadline)) {
      return Read::timeout;
    }
    const ssize_t count = ::read(descriptor_, chunk.data(), chunk.size());
    if (count > 0) {
      buffer_.append(chunk.data(), std::size_t(count));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      return Read::end;
    }
  }
  return line.size() > max_line_ ? Read::too_long : Read::line;
}

bool LineReader::has_input(Clock::time_point deadline) const {
  return !buffer_.empty() || wait_for_descriptor(descriptor_, POLLIN, deadline);
}

bool wait_for_descriptor(int descriptor, short events, LineReader::Clock::time_point deadline) {
  for (;;) {
    const auto left =
        std::chrono::duration_cast<std::chrono::nanoseconds>(deadline - LineReader::Clock::now());
    const std::int64_t ns = std::max<std::int64_t>(0, left.count());
    constexpr std::int64_t kNsPerS = 1'000'000'000;
    const timespec timeout{ns / kNsPerS, ns % kNsPerS};
    pollfd poll{descriptor, events, 0};
    const int ready = ::ppoll(&poll, 1, &timeout, nullptr);
    if (ready > 0) {
      return true;
    }
    if (ready == 0 || errno != EINTR) {
      return false;
    }
  }
}

}  // namespace limber
