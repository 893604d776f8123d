#pragma once
// For everyone.

#include <filesystem>
#include <string>

namespace limber {

/// Folder of limber's own arms/ and environments/: LIMBER_DATA_DIR if it is set, the source
/// tree for a program in `build/*/bin`, share/limber for an installed one.
/// @throws SystemFault naming the folders that were tried.
std::filesystem::path data_folder();

/// The file given, or limber's own of this name in a folder there; empty if there is neither.
std::filesystem::path own_file(const std::string& name_or_path, const char* folder,
                               const char* ending);

}  // namespace limber
