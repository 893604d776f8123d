#include "mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "limber/common/atomic_file.hpp"
#include "limber/common/file_error.hpp"

namespace limber {

MappedFile::MappedFile(const std::filesystem::path& path) : name_(path.string()) {
  require_plain_file(path);
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  struct stat status {};
  if (file < 0 || ::fstat(file, &status) != 0) {
    const int error = errno;
    (void)::close(file);
    throw_file_error(path, "can't be read", error);
  }
  size_ = static_cast<std::size_t>(status.st_size);
  void* found = nullptr;
  if (size_ > 0) {
    found = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
  }
  const int error = errno;
  (void)::close(file);
  if (found == MAP_FAILED) {
    throw_fault(path, "can't be read", error);
  }
  data_ = static_cast<char*>(found);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) {
    (void)::munmap(data_, size_);
  }
}

}  // namespace limber
