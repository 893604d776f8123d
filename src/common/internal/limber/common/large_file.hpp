#pragma once

#include <filesystem>
#include <functional>

namespace limber {

/// As write_file_atomically, for a file that is too large to be held: `make` writes all of it to
/// the name that it is given, and syncs it.
void make_file_atomically(const std::filesystem::path& path,
                          const std::function<void(const std::filesystem::path&)>& make);

/// @throws SystemFault where the disk refuses.
void sync_file(const std::filesystem::path& path);

}  // namespace limber
