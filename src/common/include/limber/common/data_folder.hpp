#pragma once
// For everyone.

#include <filesystem>

namespace limber {

/// Where limber's own arms/ and environments/ lie: LIMBER_DATA_DIR where that is set, the source
/// tree for a program in build/<preset>/bin, share/limber for an installed one.
/// @throws SystemFault naming the folders that were tried.
std::filesystem::path data_folder();

}  // namespace limber
