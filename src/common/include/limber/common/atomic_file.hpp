#pragma once
// For everyone.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace limber {

/// Largest file that is read, 4 GiB: a recording of weeks. A larger one is a mistake.
inline constexpr std::uintmax_t kMaxFile = std::uintmax_t{1} << 32U;

/// Writes `content` to a temporary name beside `path`, syncs it to disk and renames it: readers see
/// the old file or the whole new one, never a part. Missing parent folders are made. Temporary
/// files that killed processes left in the folder are removed.
/// @throws SystemFault naming the path and the system's reason, such as a full disk. The old file
/// is untouched then, and no other one is left.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// The whole file. @throws InputError if it is missing, may not be read, is no plain file (a
/// pipe would block, a device has no end) or is larger than kMaxFile; SystemFault where the
/// disk fails.
std::string read_file(const std::filesystem::path& path);

/// Its first bytes, at most `most`. @throws as read_file.
std::string read_head(const std::filesystem::path& path, std::size_t most);

/// The whole file, a block of up to 1 MB after the other. @throws as read_file.
void read_blocks(const std::filesystem::path& path,
                 const std::function<void(std::string_view)>& take);

/// Makes the checks that read_file makes before it reads, for libraries that read a path
/// themselves.
void require_plain_file(const std::filesystem::path& path);

/// Call this before the work begins, for every file that it will write. Refuses to replace an
/// existing file unless `force`, and always refuses to replace anything that is not a plain file (a
/// folder, a device, a link). Refuses a path that names no file ("", "results/") or where no file
/// can be made. Leaves nothing behind. @throws InputError that names --force, or the system's
/// reason; SystemFault if the disk is full.
///
/// Where the file was missing and somebody writes it before this process does,
/// `write_file_atomically` keeps both, its own as `PATH.2`, and throws InputError.
void refuse_to_overwrite(const std::filesystem::path& path, bool force);

/// The same for a folder that will be made or filled.
void require_writable_folder(const std::filesystem::path& folder);

/// Removes the temporary files that write_file_atomically left in `folder` because its process was
/// killed: those of this host whose process has ended.
void remove_abandoned_files(const std::filesystem::path& folder);

}  // namespace limber
