#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/median_rate.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"
#include "log_table.hpp"
#include "longest_gap.hpp"

namespace limber {

/// One unbroken recording of a log: what was tracked, and what was commanded.
/// @tparam Tracks  PointTracks in the plane, SpaceTracks in space
template <class Tracks>
struct RunOf {
  RunReport report;
  Tracks points;
  TimeColumn time;  ///< of the points
  CommandTrack commands;
  bool one_clock = true;  ///< false: the commands come on a clock of their own
};
using LogRun = RunOf<PointTracks>;

/// The recordings of one generic CSV.
/// @param want_points  adds the points' columns, behind that of the time
/// @param points_of  (table, group, report) to Tracks with their times
/// @param with_commands  false if the commands come from another file
template <class Tracks, class WantPoints, class PointsOf>
std::vector<RunOf<Tracks>> read_runs(const fs::path& path, const ImportMapping& mapping,
                                     const ArmDescription& arm, bool with_commands,
                                     const WantPoints& want_points, const PointsOf& points_of) {
  refuse_if(with_commands && !(mapping.commands.time == mapping.time),
            "{}: the mapping has the commands' times in '{}' ({}) and those of the motion in '{}' "
            "({}), and both are in one log; expected one time, or the commands in a log of their "
            "own: --pressures LOG",
            path.string(), mapping.commands.time.column, mapping.commands.time.unit,
            mapping.time.column, mapping.time.unit);
  WantedColumns wanted;
  wanted.names.push_back(mapping.time.column);
  wanted.label = mapping.recording;
  want_points(wanted);
  const std::size_t motion_column = wanted.names.size();
  if (with_commands && !mapping.motion.empty()) {
    wanted.names.push_back(mapping.motion);
  }
  const std::size_t first_command = wanted.names.size();
  if (with_commands) {
    want_commands(mapping.commands, wanted);
  }
  RunReport general;
  const LogTable table = read_log_table(path, mapping, wanted, general);
  std::vector<RunOf<Tracks>> runs;
  for (const RowGroup& group : group_rows(table)) {
    RunOf<Tracks> run;
    run.report.name = path.filename().string() + (group.label.empty() ? "" : ", " + group.label);
    run.report.rows = std::int64_t(group.rows.size());
    run.time = mapping.time;
    run.points = points_of(table, group, run.report);
    run.one_clock = with_commands;
    if (with_commands) {
      run.commands = commands_of(table, first_command, group, mapping, arm);
      run.commands.time_s = run.points.time_s;
      if (first_command > motion_column) {
        run.commands.motion = picked(table.columns[motion_column], group.rows, 1.0);
      }
    }
    runs.push_back(std::move(run));
  }
  RunReport& first = runs.front().report;
  first.notes.insert(first.notes.begin(), general.notes.begin(), general.notes.end());
  return runs;
}

/// The recordings of one generic CSV, as its mapping says.
/// @param with_commands  false if the commands come from another file.
/// @throws InputError naming file, line and column.
std::vector<LogRun> read_csv_runs(const fs::path& path, const ImportMapping& mapping,
                                  const ArmDescription& arm, bool with_commands);

/// A log of commands alone.
CommandTrack read_command_log(const fs::path& path, const ImportMapping& mapping,
                              const ArmDescription& arm, RunReport& report);

/// Brings rows into the order of time: rows without a time and repeated times are left out, single
/// rows out of order are sorted, each noted. Of commands at one time the last ones given hold.
/// @throws InputError if time is no time of one recording: shuffled, starting again, standing
/// still.
template <class Track>
void put_in_order(const std::string& log, Track& track, RunReport& report) {
  const std::vector<std::size_t> order = rows_in_order(log, track.time_s, report);
  if constexpr (std::is_same_v<Track, CommandTrack>) {
    take_repeated(order, track);
  }
  keep_rows(track, order);
}

// What imports of arms in the plane and in space do in the same way.

/// Adds how often a point was tracked. @param missing  of `rows`
/// @throws InputError where it never was
void note_point(const std::string& log, const std::string& name, int plate, Eigen::Index missing,
                Eigen::Index rows, RunReport& report);

/// Says how many rows were bridged, and how many are lost. @throws InputError where all are
void note_hidden_rows(const std::string& log, const LongestGap& longest_gap,
                      const std::vector<bool>& tracked, const std::vector<bool>& bridged,
                      RunReport& report);

/// Has rows of point `i` that are hidden for at most `longest_gap_s` bridged, and marks these and
/// the lost ones.
/// @param bridge  (row before, row behind, row, part of the time, i, tracks) puts it between both
/// @return rows in which it was missing
template <class Tracks, class Bridge>
Eigen::Index bridge_hidden_rows(double longest_gap_s, Eigen::Index i, Tracks& tracks,
                                BackboneTrack& track, const Bridge& bridge) {
  const auto time_s = [&](Eigen::Index t) { return tracks.time_s[std::size_t(t)]; };
  const Eigen::Index rows = tracks.row_count();
  Eigen::Index missing = 0;
  Eigen::Index before = -1;
  for (Eigen::Index t = 0; t <= rows; ++t) {
    if (t < rows && !tracks.is_tracked(t, i)) {
      ++missing;
      continue;
    }
    const bool is_short = before >= 0 && t < rows && time_s(t) - time_s(before) <= longest_gap_s;
    for (Eigen::Index gap = before + 1; gap < t; ++gap) {
      (is_short ? track.bridged : track.tracked)[std::size_t(gap)] = is_short;
      if (is_short) {
        const double part = (time_s(gap) - time_s(before)) / (time_s(t) - time_s(before));
        bridge(before, t, gap, part, i, tracks);
      }
    }
    before = t;
  }
  return missing;
}

/// Puts points that are missing for at most the longest gap between their neighbours in time, and
/// says in `track` which rows are tracked or bridged.
/// @throws InputError, its message beginning with `log`, where a point was never tracked or no row
/// is left
template <class Tracks, class Bridge>
void fill_gaps(const std::string& log, const LongestGap& longest_gap, Tracks& tracks,
               BackboneTrack& track, RunReport& report, const Bridge& bridge) {
  const Eigen::Index rows = tracks.row_count();
  const double longest_gap_s = longest_gap_in_s(longest_gap, tracks.time_s);
  track.tracked.assign(std::size_t(rows), true);
  track.bridged.assign(std::size_t(rows), false);
  for (Eigen::Index i = 0; i < tracks.point_count(); ++i) {
    const Eigen::Index missing = bridge_hidden_rows(longest_gap_s, i, tracks, track, bridge);
    note_point(log, tracks.names[std::size_t(i)], tracks.plates[std::size_t(i)], missing, rows,
               report);
  }
  note_hidden_rows(log, longest_gap, track.tracked, track.bridged, report);
  track.usual_step_s = quantile_step_s(tracks.time_s, kUsualSteps);
}

}  // namespace limber
