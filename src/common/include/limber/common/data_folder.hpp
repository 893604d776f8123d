#pragma once
// For everyone.

#include <filesystem>

namespace limber {

/// Folder of limber's own arms/ and environments/: LIMBER_DATA_DIR if it is set, the source
/// tree for a program in `build/*/bin`, share/limber for an installed one.
/// @throws SystemFault naming the folders that were tried.
std::filesystem::path data_folder();

}  // namespace limber
