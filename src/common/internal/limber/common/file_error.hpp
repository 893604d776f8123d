#pragma once

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

/// Whether another path, or other rights, would have helped: then it is the caller's mistake, not
/// the machine's fault.
inline bool is_callers_mistake(int error) {
  switch (error) {
    case ENOENT:
    case EACCES:
    case EPERM:
    case EROFS:
    case ENOTDIR:
    case EISDIR:
    case ELOOP:
    case ENAMETOOLONG:
    case EINVAL:
    case ETXTBSY:
      return true;
    default:
      return false;
  }
}

/// @throws SystemFault "PATH: WHAT: the system's reason", for what fails in the midst of the work.
[[noreturn]] inline void throw_fault(const fs::path& path, const std::string& what, int error) {
  throw SystemFault(fmt::format("{}: {}: {}", path.string(), what, std::strerror(error)));
}

/// The same for what is tried before the work: an InputError if the caller can correct it.
[[noreturn]] inline void throw_file_error(const fs::path& path, const std::string& what,
                                          int error) {
  if (is_callers_mistake(error)) {
    throw InputError(fmt::format("{}: {}: {}", path.string(), what, std::strerror(error)));
  }
  throw_fault(path, what, error);
}

}  // namespace limber
