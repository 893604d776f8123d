#include "recording_pipe.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "confined_child.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr std::size_t kWriteBuffer = std::size_t{1} << 16U;

}  // namespace

void PipeWriter::write_out(const char* data, std::size_t size) const {
  while (size > 0) {
    const ssize_t count = ::write(pipe_, data, size);
    if (count < 0 && errno != EINTR) {
      throw EndOfPipe{};  // nobody reads any more
    }
    data += std::max<ssize_t>(count, 0);
    size -= std::size_t(std::max<ssize_t>(count, 0));
  }
}

void PipeWriter::flush() {
  write_out(buffer_.data(), buffer_.size());
  buffer_.clear();
}

void PipeWriter::bytes(const void* data, std::size_t size) {
  const char* first = static_cast<const char*>(data);
  if (buffer_.size() + size > kWriteBuffer) {
    flush();
  }
  if (size > kWriteBuffer) {
    write_out(first, size);
  } else {
    buffer_.insert(buffer_.end(), first, first + size);
  }
}

std::size_t PipeReader::announce(std::size_t /*items*/, std::size_t size_of_one) {
  std::size_t items = 0;
  bytes(&items, sizeof items);
  refuse_if(items > left_ / std::max<std::size_t>(size_of_one, 1),
            "{}: holds more numbers than a file of its size can: it is "
            "damaged, or made to do harm; expected a whole recording",
            name_);
  left_ -= items * size_of_one;
  return items;
}

std::size_t PipeReader::read_some(char* data, std::size_t size) const {
  while (true) {
    pollfd ready{pipe_, POLLIN, 0};
    const int found = ::poll(&ready, 1, silence_ms_);
    if (found == 0) {
      throw EndOfPipe{true};
    }
    const ssize_t count = found < 0 ? -1 : ::read(pipe_, data, size);
    if (count > 0) {
      return std::size_t(count);
    }
    if (count == 0 || errno != EINTR) {
      throw EndOfPipe{};
    }
  }
}

void PipeReader::bytes(void* data, std::size_t size) {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    if (begin_ == end_ && size >= buffer_.size()) {
      const std::size_t count = read_some(next, size);
      next += count;
      size -= count;
      continue;
    }
    if (begin_ == end_) {
      begin_ = 0;
      end_ = read_some(buffer_.data(), buffer_.size());
    }
    const std::size_t count = std::min(size, end_ - begin_);
    std::memcpy(next, buffer_.data() + begin_, count);
    begin_ += count;
    next += count;
    size -= count;
  }
}

}  // namespace limber
