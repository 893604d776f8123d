#pragma once

#include <filesystem>
#include <functional>

#include "limber/common/filesystem.hpp"

namespace limber {

/// As write_file_atomically, for a file that is too large to be held: `make` writes all of it to
/// the name that it is given, and syncs it.
void make_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& make);

/// @throws SystemFault where the disk refuses.
void sync_file(const fs::path& path);

}  // namespace limber
