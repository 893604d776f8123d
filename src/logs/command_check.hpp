#pragma once

#include <string>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_tracks.hpp"

namespace limber {

/// Bridges commands missing for at most `mapping.longest_gap_s` (set points: holds
/// those before, for however long), and refuses what is no log of this arm's
/// commands: a column without numbers, values far beyond the limits, nothing that
/// ever changes. Notes single commands that never change or overshoot a little.
/// @throws InputError, its message beginning with `log`.
void check_commands(const std::string& log, const ImportMapping& mapping, const ArmDescription& arm,
                    CommandTrack& commands, RunReport& report);

}  // namespace limber
