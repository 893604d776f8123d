#pragma once

#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "limber/common/filesystem.hpp"

namespace limber {

/// A file descriptor, closed at the end of the scope.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  /// What open() gives for it, with O_CLOEXEC.
  Descriptor(const fs::path& path, int flags) {
    constexpr mode_t kNewFile = 0666;  // less what the umask takes away
    do {
      descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, kNewFile);
    } while (descriptor_ < 0 && errno == EINTR);
  }
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

  bool is_open() const { return descriptor_ >= 0; }
  int get() const { return descriptor_; }

  /// Network file systems may tell only here that something was not written.
  bool close() {
    const int descriptor = std::exchange(descriptor_, -1);
    return descriptor < 0 || ::close(descriptor) == 0 || errno == EINTR;
  }

 private:
  int descriptor_ = -1;
};

}  // namespace limber
