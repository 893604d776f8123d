#pragma once
// For those who read or write recordings.

#include <filesystem>
#include <optional>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// What is to be imported, besides the motion logs.
struct ImportOptions {
  ImportMapping mapping;
  /// Commands on a clock of their own, one log for each motion log; empty: they stand in the motion
  /// logs (generic CSV only).
  std::vector<std::filesystem::path> command_logs;
  /// Added to the commands' times; none: found by correlation if they have a clock of their own.
  std::optional<double> time_offset_s;
};

struct ImportResult {
  Recording recording;
  ImportReport report;
};

/// A recording from generic CSV logs (docs/importing.md); each file is one recording, or several
/// if the mapping names a column that tells them apart.
/// @throws InputError naming file and place, what was found, what is allowed and what to do.
ImportResult import_csv(const std::vector<std::filesystem::path>& logs,
                        const ImportOptions& options, const ArmDescription& arm);

/// The same from OptiTrack Motive's CSV exports.
ImportResult import_motive(const std::vector<std::filesystem::path>& logs,
                           const ImportOptions& options, const ArmDescription& arm);

}  // namespace limber
