#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_table.hpp"
#include "log_tracks.hpp"

namespace limber {

/// Which rows of a table belong to one recording.
struct RowGroup {
  std::string label;
  std::vector<std::size_t> rows;
};

/// By the table's labels, in the order of first appearance; one group where it has none.
std::vector<RowGroup> group_rows(const LogTable& table);
RowGroup all_rows(const LogTable& table);

/// Those rows of a column, times `factor`.
std::vector<double> picked(const std::vector<double>& column, const std::vector<std::size_t>& rows,
                           double factor);

/// Adds the command columns in the order that `commands_of` reads them.
void want_commands(const CommandColumns& commands, WantedColumns& wanted);

/// Commands in the arm's unit, without times. @param first  the table's first command column
CommandTrack commands_of(const LogTable& table, std::size_t first, const RowGroup& group,
                         const ImportMapping& mapping, const ArmDescription& arm);

/// The rows to keep, in the order of time (log_runs.hpp, put_in_order).
std::vector<std::size_t> rows_in_order(const std::string& log, const std::vector<double>& time_s,
                                       RunReport& report);

}  // namespace limber
