#pragma once

#include <filesystem>
#include <string>

namespace limber {

/// Makes an empty folder for a run's results, marked as the verb's own (a file `.limber-VERB` in
/// it), so that the next run may replace it, finished or not.
/// @throws InputError where `folder` holds files and is not marked, unless `force`; or where it is
/// a file.
/// @throws SystemFault where it can't be emptied or made.
void prepare_output_folder(const std::filesystem::path& folder, bool force,
                           const std::string& verb = "demo");

}  // namespace limber
