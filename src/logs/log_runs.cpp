#include "log_runs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "log_rows.hpp"
#include "log_table.hpp"
#include "longest_gap.hpp"

namespace limber {

namespace {

PointTracks points_of(const LogTable& table, const RowGroup& group, const ImportMapping& mapping,
                      RunReport& report) {
  PointTracks tracks;
  tracks.time_s = picked(table.columns[0], group.rows, mapping.time.seconds_per_unit);
  const auto k = Eigen::Index(mapping.points.size());
  const auto rows = Eigen::Index(group.rows.size());
  tracks.x_m.resize(rows, k);
  tracks.y_m.resize(rows, k);
  const bool headings = !mapping.points.front().theta.empty();
  if (headings) {
    tracks.theta_rad.resize(rows, k);
  }
  std::size_t column = 1;
  const auto take = [&](Eigen::MatrixXd& matrix, Eigen::Index i, double factor) {
    const std::vector<double> values = picked(table.columns[column++], group.rows, factor);
    matrix.col(i) = Eigen::Map<const Eigen::VectorXd>(values.data(), rows);
  };
  for (Eigen::Index i = 0; i < k; ++i) {
    const PointSource& point = mapping.points[std::size_t(i)];
    const std::vector<bool> zeros =
        rows_of_zeros(table, group, column, headings ? 3 : 2, point, mapping, report);
    tracks.names.push_back(point.x);
    tracks.plates.push_back(point.plate);
    take(tracks.x_m, i, mapping.length_factor);
    take(tracks.y_m, i, mapping.length_factor);
    if (headings) {
      take(tracks.theta_rad, i, mapping.angle_factor);
    }
    for (Eigen::Index t = 0; t < rows; ++t) {
      if (zeros[std::size_t(t)]) {
        tracks.x_m(t, i) = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
  return tracks;
}

void require_csv_points(const fs::path& path, const ImportMapping& mapping) {
  refuse_if(mapping.points.empty(),
            "{}: the mapping names no points; expected 'backbone: {{points: "
            "[{{x: COLUMN, y: COLUMN}}, …]}}', base first",
            path.string());
  const bool headings = !mapping.points.front().theta.empty();
  for (const PointSource& point : mapping.points) {
    if (point.x.empty()) {
      throw InputError(fmt::format(
          "{}: {} is mapped to an object of a Motive file; expected the columns x and y",
          path.string(), plate_name(point.plate)));
    }
    if (point.theta.empty() == headings) {
      throw InputError(
          fmt::format("{}: {} has {} theta column, the base has {}; expected all "
                      "points with a heading or all without",
                      path.string(), plate_name(point.plate), headings ? "no" : "a",
                      headings ? "one" : "none"));
    }
  }
}

bool has_column(const fs::path& path, const ImportMapping& mapping, const std::string& name) {
  const std::vector<std::string> names = log_columns(path, mapping);
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::vector<LogRun> read_csv_runs(const fs::path& path, const ImportMapping& mapping,
                                  const ArmDescription& arm, bool with_commands) {
  require_csv_points(path, mapping);
  const auto want_points = [&](WantedColumns& wanted) {
    for (const PointSource& point : mapping.points) {
      wanted.names.insert(wanted.names.end(), {point.x, point.y});
      if (!point.theta.empty()) {
        wanted.names.push_back(point.theta);
      }
    }
  };
  return read_runs<PointTracks>(
      path, mapping, arm, with_commands, want_points,
      [&](const LogTable& table, const RowGroup& group, RunReport& report) {
        return points_of(table, group, mapping, report);
      });
}

CommandTrack read_command_log(const fs::path& path, const ImportMapping& mapping,
                              const ArmDescription& arm, RunReport& report) {
  WantedColumns wanted;
  wanted.names.push_back(mapping.commands.time.column);
  const bool numbered = !mapping.motion.empty() && has_column(path, mapping, mapping.motion);
  if (numbered) {
    wanted.names.push_back(mapping.motion);
  } else if (!mapping.motion.empty()) {
    report.note("the log of commands has no column 'motion': motions are found from the commands",
                fmt::format("'{}'", mapping.motion));
  }
  const std::size_t first_command = wanted.names.size();
  want_commands(mapping.commands, wanted);
  const LogTable table = read_log_table(path, mapping, wanted, report);
  const RowGroup all = group_rows(table).front();
  CommandTrack track = commands_of(table, first_command, all, mapping, arm);
  track.time_s = picked(table.columns[0], all.rows, mapping.commands.time.seconds_per_unit);
  if (numbered) {
    track.motion = picked(table.columns[1], all.rows, 1.0);
  }
  return track;
}

void note_point(const std::string& log, const std::string& name, int plate, Eigen::Index missing,
                Eigen::Index rows, RunReport& report) {
  report.points.push_back({name, plate, 1.0 - double(missing) / double(rows)});
  if (missing == rows) {
    throw InputError(fmt::format(
        "{}: point '{}' ({}) is never tracked: all of its cells are empty. Leave it out of the "
        "mapping, and its plate is put between its neighbours; or track it",
        log, name, plate_name(plate)));
  }
}

void note_hidden_rows(const std::string& log, const LongestGap& longest_gap,
                      const std::vector<bool>& tracked, const std::vector<bool>& bridged,
                      RunReport& report) {
  const auto filled = std::ranges::count(bridged, true);
  const auto lost = std::ranges::count(tracked, false);
  if (filled > 0) {
    report.note(
        fmt::format("rows in which a point was missing for at most {} s and was put between "
                    "its neighbours in time (their frames count as not tracked)",
                    longest_gap),
        {}, filled);
  }
  if (lost > 0) {
    report.note("rows left out in which a point was missing for longer", {}, lost);
  }
  refuse_if(
      lost == std::ssize(tracked),
      "{}: in none of the {} rows are all points tracked, or hidden for less than {} s. Leave "
      "points that are often hidden out of the mapping",
      log, tracked.size(), longest_gap);
}

}  // namespace limber
