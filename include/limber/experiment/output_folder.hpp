#pragma once

#include <filesystem>

namespace limber {

/// Makes an empty folder for a run's results, marked as limber's own (a file `.limber-demo` in it),
/// so that the next run may replace it, finished or not.
/// @throws InputError where `folder` holds files and is not marked, unless `force`; or where it is
/// a file.
/// @throws SystemFault where it can't be emptied or made.
void prepare_output_folder(const std::filesystem::path& folder, bool force);

}  // namespace limber
