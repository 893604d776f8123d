#pragma once

#include <filesystem>
#include <vector>

#include "limber/logs/log_import.hpp"

namespace limber {

/// import_csv and import_motive of an arm in space. Commands of another file are on the motion
/// log's clock, or `time_offset_s` off it: nothing is found by correlation.
ImportResult import_space_csv(const std::vector<std::filesystem::path>& logs,
                              const ImportOptions& options, const ArmDescription& arm);
ImportResult import_space_motive(const std::vector<std::filesystem::path>& logs,
                                 const ImportOptions& options, const ArmDescription& arm);

}  // namespace limber
