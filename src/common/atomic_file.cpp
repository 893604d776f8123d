#include "limber/common/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const char* what, const fs::path& path) {
  throw SystemFault(fmt::format("{}: {}: {}", path.string(), what, std::strerror(errno)));
}

/// A file descriptor, closed on the way out.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : descriptor_(::open(path.c_str(), flags)) {
    if (descriptor_ < 0) {
      fail("can't be opened", path);
    }
  }
  ~Descriptor() { ::close(descriptor_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

void sync_to_disk(const fs::path& path, int flags) {
  const Descriptor descriptor(path, flags);
  // Some file systems can't sync a folder (EINVAL); the rename is atomic on them all the same.
  if (::fsync(descriptor.get()) != 0 && errno != EINVAL) {
    fail("can't be synced to disk", path);
  }
}

}  // namespace

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw SystemFault(
        fmt::format("{}: folder can't be made: {}", folder.string(), error.message()));
  }
  const fs::path temporary =
      folder / fmt::format(".{}.{}.tmp", path.filename().string(), ::getpid());
  try {
    write(temporary);
    sync_to_disk(temporary, O_RDONLY);
    if (::rename(temporary.c_str(), path.c_str()) != 0) {
      fail("can't be renamed into place", path);
    }
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  sync_to_disk(folder, O_RDONLY | O_DIRECTORY);
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_atomically(path, [&](const fs::path& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
      fail("can't be written", path);
    }
  });
}

std::string read_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw InputError(fmt::format("{}: is a folder; expected a file", path.string()));
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw InputError(fmt::format("{}: can't be read: {}", path.string(), std::strerror(errno)));
  }
  std::ostringstream content;
  content << stream.rdbuf();
  return std::move(content).str();
}

void refuse_to_overwrite(const fs::path& path, bool force) {
  const fs::file_status status = fs::symlink_status(path);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    throw InputError(
        fmt::format("{}: exists and is no plain file; it is never replaced", path.string()));
  }
  if (path.has_parent_path() && fs::exists(path.parent_path()) &&
      !fs::is_directory(path.parent_path())) {
    throw InputError(
        fmt::format("{}: {} is no folder", path.string(), path.parent_path().string()));
  }
  if (!force && fs::exists(path)) {
    throw InputError(fmt::format("{}: exists already; --force replaces it", path.string()));
  }
}

}  // namespace limber
