#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_tracks.hpp"

namespace limber {

/// One unbroken recording of a log: what was tracked, and what was commanded.
struct LogRun {
  RunReport report;
  PointTracks points;
  TimeColumn time;  ///< of the points
  CommandTrack commands;
  bool one_clock = true;  ///< false: the commands come on a clock of their own
};

/// The recordings of one generic CSV, as its mapping says.
/// @param with_commands  false if the commands come from another file.
/// @throws InputError naming file, line and column.
std::vector<LogRun> read_csv_runs(const std::filesystem::path& path, const ImportMapping& mapping,
                                  const ArmDescription& arm, bool with_commands);

/// A log of commands alone.
CommandTrack read_command_log(const std::filesystem::path& path, const ImportMapping& mapping,
                              const ArmDescription& arm, RunReport& report);

/// Brings rows into the order of time: rows without a time and repeated times are left out, single
/// rows out of order are sorted, each noted.
/// @throws InputError if time is no time of one recording: shuffled, starting again, standing
/// still.
void put_in_order(const std::string& log, PointTracks& tracks, RunReport& report);
void put_in_order(const std::string& log, CommandTrack& track, RunReport& report);

}  // namespace limber
