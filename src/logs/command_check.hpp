#pragma once

#include <string>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"

namespace limber {

/// Where the log holds the arm file's `commands`: their sums, one for each segment, and a note that
/// says which. A sum of measured commands is missing where one of them is; of set points those
/// before stay in force. Rows are in the order of time.
void sum_commands(const ImportMapping& mapping, const ArmDescription& arm, CommandTrack& commands,
                  RunReport& report);

/// T×M set points: an empty cell says nothing new.
void hold_setpoints(Eigen::MatrixXd& values);

/// The mapping with each segment's sum in place of its columns, for messages.
ImportMapping with_sums_named(ImportMapping mapping, const ArmDescription& arm);

/// Bridges commands missing for at most `mapping.longest_gap_s` (set points: holds those before,
/// for however long, also beside measured ones), and refuses what is no log of this arm's commands:
/// a column without numbers, values far beyond the limits, nothing that ever changes. Notes single
/// commands that never change or overshoot a little.
/// @throws InputError, its message beginning with `log`.
void check_commands(const std::string& log, const ImportMapping& mapping, const ArmDescription& arm,
                    CommandTrack& commands, RunReport& report);

}  // namespace limber
