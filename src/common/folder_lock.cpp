#include "limber/common/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>

#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

/// Whether the descriptor is still what has that name.
bool has_name(int descriptor, const fs::path& folder) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::stat(folder.c_str(), &named) == 0 &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, const std::string& who) {
  constexpr int kTries = 100;  // of a folder that others remove and make
  for (int k = 0; k < kTries; ++k) {
    std::error_code error;
    fs::create_directories(folder, error);
    descriptor_ = Descriptor(folder, O_RDONLY | O_DIRECTORY);
    if (!descriptor_.is_open()) {
      return;  // whoever writes there says why that can't be done
    }
    refuse_if(::flock(descriptor_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK,
              "{}: another {} is writing there; wait for its end, or choose another --out",
              folder.string(), who);
    if (has_name(descriptor_.get(), folder)) {
      return;  // also where a file system has no locks
    }
    descriptor_.close();
  }
}

}  // namespace limber
