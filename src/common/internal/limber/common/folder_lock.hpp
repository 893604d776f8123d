#pragma once

#include <filesystem>
#include <string>

#include "limber/common/descriptor.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

/// Makes a folder and keeps other processes, and others in this one, from locking it, as long as it
/// lives or the process does. It leaves nothing behind. File systems without locks have none.
class FolderLock {
 public:
  /// @param who  "limber experiment", for the message
  /// @throws InputError if another has it.
  FolderLock(const fs::path& folder, const std::string& who);

 private:
  Descriptor descriptor_;
};

}  // namespace limber
