#include "limber/common/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>

#include "limber/common/descriptor.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/large_file.hpp"
#include "limber/common/refuse_if.hpp"
#include "temporary_file.hpp"

namespace limber {

namespace {

bool sync(int descriptor) {
  while (::fsync(descriptor) != 0) {
    // Some file systems can't sync a folder (EINVAL); the rename is atomic on them all the same.
    if (errno != EINTR) {
      return errno == EINVAL;
    }
  }
  return true;
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    content.remove_prefix(std::size_t(std::max<ssize_t>(written, 0)));
  }
  return true;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Files that refuse_to_overwrite found missing: whoever writes one while we work must not lose it.
class MissingFiles {
 public:
  void set(const fs::path& path, bool is_missing) {
    const std::lock_guard lock(mutex_);
    if (is_missing) {
      paths_.insert(name(path));
    } else {
      paths_.erase(name(path));
    }
  }
  bool has(const fs::path& path) {
    const std::lock_guard lock(mutex_);
    return paths_.contains(name(path));
  }

 private:
  static std::string name(const fs::path& path) {
    std::error_code error;
    return fs::absolute(path, error).lexically_normal().string();
  }

  std::mutex mutex_;
  std::set<std::string> paths_;
};

MissingFiles& missing_files() {
  static MissingFiles files;
  return files;
}

/// Renames where nothing has that name; false where something has. Not all file systems can do that
/// at once; some have no links either, and there it is checked just before.
bool rename_to_new(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return true;
  }
  if (errno == EINVAL || errno == ENOSYS || errno == ENOTSUP) {
    if (::link(from.c_str(), to.c_str()) == 0) {
      ::unlink(from.c_str());
      return true;
    }
    if (errno != EEXIST) {
      std::error_code error;
      if (fs::exists(fs::symlink_status(to, error))) {
        return false;
      }
      if (::rename(from.c_str(), to.c_str()) == 0) {
        return true;
      }
    }
  }
  if (errno != EEXIST) {
    throw_fault(to, "can't be renamed into place", errno);
  }
  return false;
}

/// What was made is not lost where somebody else took its name meanwhile.
[[noreturn]] void keep_beside(const fs::path& temporary, const fs::path& path) {
  constexpr int kMaxNames = 1000;
  for (int k = 2; k < kMaxNames; ++k) {
    const fs::path beside = fmt::format("{}.{}", path.string(), k);
    refuse_if(rename_to_new(temporary, beside),
              "{}: exists already: it was written while this run worked, whose own file is "
              "{}; --force replaces it",
              path.string(), beside.string());
  }
  throw InputError(fmt::format("{}: exists already; --force replaces it", path.string()));
}

void rename_into_place(const fs::path& temporary, const fs::path& path) {
  if (missing_files().has(path)) {
    if (!rename_to_new(temporary, path)) {
      keep_beside(temporary, path);
    }
    missing_files().set(path, false);  // it is ours now
  } else if (::rename(temporary.c_str(), path.c_str()) != 0) {
    throw_fault(path, "can't be renamed into place", errno);
  }
}

/// The folder in which the first of the missing ones would be made, or the file itself.
fs::path existing_folder(const fs::path& path) {
  fs::path folder = folder_of(path);
  std::error_code error;
  while (!fs::exists(fs::symlink_status(folder, error)) && folder.has_relative_path() &&
         folder != folder_of(folder)) {
    // A name that is too long, or in a folder that may not be read, can't exist for us.
    if (error && error != std::errc::no_such_file_or_directory &&
        error != std::errc::not_a_directory) {
      throw_file_error(path, "can't be written", error.value());
    }
    folder = folder_of(folder);
  }
  return folder;
}

/// Makes a file in the folder where `path` will be, and removes it.
void require_writable(const fs::path& path) {
  const fs::path folder = existing_folder(path);
  std::error_code error;
  refuse_if(!fs::is_directory(folder, error), "{}: {} is no folder", path.string(),
            folder.string());
  const long longest = ::pathconf(folder.c_str(), _PC_NAME_MAX);
  for (const fs::path& part : path) {
    refuse_if(longest > 0 && part.string().size() > std::size_t(longest),
              "{}: a name of {} bytes is too long; at most {} are allowed there", path.string(),
              part.string().size(), longest);
  }
  remove_abandoned_files_once(folder);  // a run that was killed here may write elsewhere now
  const fs::path probe = folder / temporary_name(path.filename().string());
  Descriptor file(probe, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.is_open()) {
    throw_file_error(
        path, fmt::format("can't be written: no file can be made in {}", folder.string()), errno);
  }
  ::unlink(probe.c_str());
}

[[noreturn]] void refuse_size(const fs::path& path, std::uintmax_t size) {
  throw InputError(fmt::format("{}: {} bytes or more; files of up to {} bytes are read",
                               path.string(), size, kMaxFile));
}

Descriptor open_to_read(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    throw_file_error(path, "can't be read", errno);
  }
  refuse_if(S_ISDIR(status.st_mode), "{}: is a folder; expected a file", path.string());
  // A pipe would block, and a device has no end.
  refuse_if(!S_ISREG(status.st_mode), "{}: is a pipe or a device; expected a plain file",
            path.string());
  if (std::uintmax_t(status.st_size) > kMaxFile) {
    refuse_size(path, std::uintmax_t(status.st_size));
  }
  Descriptor file(path, O_RDONLY | O_NONBLOCK);
  if (!file.is_open()) {
    throw_file_error(path, "can't be read", errno);
  }
  return file;
}

/// A folder, a device or a link: for root, a rename would put a file in the place of /dev/null.
void refuse_to_replace(const fs::path& path, const fs::file_status& status) {
  refuse_if(fs::exists(status) && !fs::is_regular_file(status),
            "{}: exists and is not a plain file; it is never replaced", path.string());
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  make_file_atomically(path, [&](const fs::path& temporary) {
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL);
    if (!file.is_open() || !write_all(file.get(), content) || !sync(file.get()) || !file.close()) {
      throw_fault(path, "can't be written", errno);
    }
  });
}

void make_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& make) {
  const fs::path folder = folder_of(path);
  std::error_code error;
  refuse_to_replace(path, fs::symlink_status(path, error));
  fs::create_directories(folder, error);
  if (error) {
    throw_fault(folder, "folder can't be made", error.value());
  }
  remove_abandoned_files_once(folder);
  const fs::path temporary = folder / temporary_name(path.filename().string());
  try {
    make(temporary);
    rename_into_place(temporary, path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  Descriptor parent(folder, O_RDONLY | O_DIRECTORY);
  // A folder that may be written to, but not read, can't be synced.
  if (parent.is_open() ? !sync(parent.get()) : errno != EACCES) {
    throw_fault(folder, "can't be synced to disk", errno);
  }
}

void sync_file(const fs::path& path) {
  Descriptor file(path, O_WRONLY);
  if (!file.is_open() || !sync(file.get()) || !file.close()) {
    throw_fault(path, "can't be written", errno);
  }
}

void require_plain_file(const fs::path& path) {
  (void)open_to_read(path);
}

namespace {

/// Reads up to `most` bytes. @return how many; 0 at the end
std::size_t read_some(const Descriptor& file, const fs::path& path, char* to, std::size_t most) {
  while (true) {
    const ssize_t count = ::read(file.get(), to, most);
    if (count >= 0) {
      return std::size_t(count);
    }
    if (errno != EINTR) {
      throw_fault(path, "can't be read", errno);
    }
  }
}

}  // namespace

std::string read_file(const fs::path& path) {
  const Descriptor file = open_to_read(path);
  struct stat status {};
  const bool has_size = ::fstat(file.get(), &status) == 0 && status.st_size > 0;
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  // One byte more than expected shows the end without another block; the kernel's own files say
  // that they are empty.
  std::string content(has_size ? std::size_t(status.st_size) + 1 : kBlock, '\0');
  std::size_t size = 0;
  while (true) {
    const std::size_t count = read_some(file, path, content.data() + size, content.size() - size);
    if (count == 0) {
      content.resize(size);
      return content;
    }
    size += count;
    if (size > kMaxFile) {
      refuse_size(path, size);
    }
    if (size == content.size()) {
      content.resize(size + size / 2 + kBlock);
    }
  }
}

std::string read_head(const fs::path& path, std::size_t most) {
  const Descriptor file = open_to_read(path);
  std::string head(most, '\0');
  std::size_t size = 0;
  std::size_t count = 0;
  do {
    count = read_some(file, path, head.data() + size, most - size);
    size += count;
  } while (count > 0);
  head.resize(size);
  return head;
}

void read_blocks(const fs::path& path, const std::function<void(std::string_view)>& take) {
  const Descriptor file = open_to_read(path);
  std::string block(std::size_t{1} << 20U, '\0');
  while (const std::size_t count = read_some(file, path, block.data(), block.size())) {
    take(std::string_view(block).substr(0, count));
  }
}

void refuse_to_overwrite(const fs::path& path, bool force) {
  refuse_if(!path.has_filename(), "'{}': names no file; expected a file to write", path.string());
  std::error_code error;
  const fs::file_status status = fs::symlink_status(path, error);
  refuse_to_replace(path, status);
  refuse_if(!force && fs::exists(status), "{}: exists already; --force replaces it", path.string());
  require_writable(path);
  missing_files().set(path, !force);
}

void require_writable_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  refuse_if(folder.empty(), "'': names no folder; expected one to write into");
  refuse_if(fs::exists(status) && !fs::is_directory(status),
            "{}: is a file; expected a folder, or nothing", folder.string());
  require_writable(folder / "");
}

}  // namespace limber
