#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace limber {

/// Writes `content` to a temporary name beside `path`, syncs it to disk and renames it: readers see
/// the old file or the whole new one, never a part. Missing parent folders are made.
/// @throws SystemFault naming the path and the system's reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The same for libraries that write to a path themselves: `write` gets the temporary path. Where
/// it throws, the temporary file is removed and `path` is untouched.
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

/// The whole file. @throws InputError where it is missing or can't be read.
std::string read_file(const std::filesystem::path& path);

/// Refuses to replace an existing file unless `force`, and anything that is no plain file (a
/// folder, a device, a link) always. To be asked before the work begins. @throws InputError that
/// names --force.
void refuse_to_overwrite(const std::filesystem::path& path, bool force);

}  // namespace limber
