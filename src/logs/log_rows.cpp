#include "log_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

namespace {

constexpr std::size_t kQuaternion = 4;
constexpr double kUnturned_rad = 0.1;  // of a base whose frame is the log's; noise is far less

/// Sums of the squares of one point's cells in one row.
struct PointSquares {
  double place = 0.0;
  double turn = 0.0;
  double largest_turn = 0.0;  // one cell's

  bool are_zeros() const { return place == 0.0 && turn == 0.0; }
  /// At the origin, and of four cells one is 1 or -1: no turn, whichever cell is w.
  bool are_identity(bool has_quaternion) const {
    return has_quaternion && place == 0.0 && turn == 1.0 && largest_turn == 1.0;
  }
  double turned_rad() const {
    return turn > 0.0 ? 2.0 * std::acos(std::min(1.0, std::sqrt(largest_turn / turn))) : 0.0;
  }
};

PointSquares squares_of(const LogTable& table, std::size_t row, std::size_t first, std::size_t axes,
                        std::size_t cells) {
  PointSquares squares;
  for (std::size_t c = 0; c < cells; ++c) {
    const double square = std::pow(table.columns[first + c][row], 2);
    if (c < axes) {
      squares.place += square;
    } else {
      squares.turn += square;
      squares.largest_turn = std::max(squares.largest_turn, square);
    }
  }
  return squares;
}

void append(std::vector<std::string>& names, const std::vector<std::string>& more) {
  names.insert(names.end(), more.begin(), more.end());
}

/// A pressure on both sides at once has no signed number.
void require_one_side(const LogTable& table, std::size_t row, const ArmDescription& arm,
                      Eigen::Index segment, double right, double left) {
  constexpr double kBothSides = 0.1;  // of the limit; gauges at rest read a little
  const double limit = arm.segments[segment].pressure_limit_kpa.largest_kpa();
  if (right > kBothSides * limit && left > kBothSides * limit) {  // not where one was not logged
    throw InputError(fmt::format(
        "{}: line {}: {} has {:.4g} {unit} on its right and {:.4g} {unit} on its left; limber's "
        "arms pressurise one side at a time, and at most {:.4g} {unit} (10 % of the limit) may be "
        "left on the other. Is the unit right? If your valves overlap, log one signed column",
        table.file, table.lines[row], segment_name(segment), right, left, kBothSides * limit,
        fmt::arg("unit", arm.command.unit)));
  }
}

/// Puts rows that stand out of order where they belong. @throws InputError where they are many
void sort_rows(const std::string& log, const std::vector<double>& time_s, RunReport& report,
               std::vector<std::size_t>& order) {
  constexpr double kMaxOutOfOrder = 0.01;
  constexpr double kFarthestBack_s = 0.5;
  std::size_t back = 0;
  std::size_t first = 0;
  double farthest_s = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const double step = time_s[order[i]] - time_s[order[i - 1]];
    if (step < 0.0) {
      first = back++ == 0 ? i : first;
      farthest_s = std::max(farthest_s, -step);
    }
  }
  if (back == 0) {
    return;
  }
  const std::string where = fmt::format("row {} at {:.6g} s follows {:.6g} s", order[first],
                                        time_s[order[first]], time_s[order[first - 1]]);
  refuse_if(double(back) > kMaxOutOfOrder * double(order.size()) || farthest_s > kFarthestBack_s,
            "{}: time goes back {} times, by up to {:.3g} s; first, {}. Is the column named in "
            "'time' the time? Rows that were shuffled have to be sorted; a file that holds several "
            "recordings needs a column that tells them apart, named in the mapping as 'recording'",
            log, back, farthest_s, where);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return time_s[a] < time_s[b]; });
  report.note("rows out of order, sorted by time", fmt::format("{}: {}", log, where),
              std::int64_t(back));
}

void drop_repeated_rows(const std::string& log, const std::vector<double>& time_s,
                        RunReport& report, std::vector<std::size_t>& order) {
  std::vector<std::size_t> kept;
  for (const std::size_t row : order) {
    if (!kept.empty() && time_s[row] <= time_s[kept.back()]) {
      report.note("rows left out that repeat a time",
                  fmt::format("{}: row {} at {:.6g} s", log, row, time_s[row]));
    } else {
      kept.push_back(row);
    }
  }
  order = std::move(kept);
}

}  // namespace

void keep_rows(std::vector<double>& values, const std::vector<std::size_t>& order) {
  if (!values.empty()) {
    values = picked(values, order, 1.0);
  }
}

void keep_rows(Eigen::MatrixXd& matrix, const std::vector<std::size_t>& order) {
  if (matrix.size() > 0) {
    matrix = matrix(order, Eigen::all).eval();
  }
}

void keep_rows(PointTracks& tracks, const std::vector<std::size_t>& order) {
  keep_rows(tracks.time_s, order);
  keep_rows(tracks.x_m, order);
  keep_rows(tracks.y_m, order);
  keep_rows(tracks.theta_rad, order);
}

void keep_rows(CommandTrack& track, const std::vector<std::size_t>& order) {
  keep_rows(track.time_s, order);
  keep_rows(track.values, order);
  keep_rows(track.setpoint, order);
  keep_rows(track.motion, order);
}

std::vector<RowGroup> group_rows(const LogTable& table) {
  std::vector<RowGroup> groups;
  std::map<std::string, std::size_t> group_of;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string label = table.labels.empty() ? std::string() : table.labels[row];
    const auto [entry, is_new] = group_of.emplace(label, groups.size());
    if (is_new) {
      groups.push_back({label, {}});
    }
    groups[entry->second].rows.push_back(row);
  }
  return groups;
}

std::vector<double> picked(const std::vector<double>& column, const std::vector<std::size_t>& rows,
                           double factor) {
  return mapped<double>(rows, [&](const std::size_t row) { return factor * column[row]; });
}

std::vector<bool> rows_of_zeros(const LogTable& table, const RowGroup& group, std::size_t first,
                                std::size_t cells, const PointSource& point,
                                const ImportMapping& mapping, RunReport& report) {
  const std::size_t axes = point.z.empty() ? 2 : 3;
  const bool has_quaternion = cells == axes + kQuaternion;
  std::vector<PointSquares> squares;
  std::vector<double> from_origin_m;  // of rows that show the point
  std::vector<double> turned_rad;
  std::ptrdiff_t identities = 0;
  for (const std::size_t row : group.rows) {
    const PointSquares one = squares_of(table, row, first, axes, cells);
    squares.push_back(one);
    identities += one.are_identity(has_quaternion) ? 1 : 0;
    if (!one.are_zeros() && !one.are_identity(has_quaternion) && std::isfinite(one.place)) {
      from_origin_m.push_back(mapping.length_factor * std::sqrt(one.place));
      turned_rad.push_back(has_quaternion ? one.turned_rad() : 0.0);
    }
  }
  // Bases may lie at the origin, and unturned. A quaternion is never 0.
  const bool is_usual = point.plate == 0 && 2 * identities >= std::ssize(squares);
  const bool may_be_there =
      is_usual || from_origin_m.empty() ||
      (median(from_origin_m) < kBaseStandsStill_m && median(turned_rad) < kUnturned_rad);
  std::vector<bool> hidden;
  for (std::size_t t = 0; t < squares.size(); ++t) {
    hidden.push_back(squares[t].are_zeros()
                         ? has_quaternion || !may_be_there
                         : squares[t].are_identity(has_quaternion) && !may_be_there);
    if (hidden.back()) {
      report.note("points of zeros alone, or zeros and no turn, in a row: not tracked",
                  fmt::format("line {}, {}", table.lines[group.rows[t]], plate_name(point.plate)));
    }
  }
  return hidden;
}

void want_commands(const CommandColumns& commands, WantedColumns& wanted) {
  append(wanted.names, commands.columns);
  append(wanted.names, commands.right);
  append(wanted.names, commands.left);
  append(commands.setpoint_optional ? wanted.optional : wanted.names, commands.setpoint);
}

CommandTrack commands_of(const LogTable& table, std::size_t first, const RowGroup& group,
                         const ImportMapping& mapping, const ArmDescription& arm) {
  const CommandColumns& commands = mapping.commands;
  const auto rows = Eigen::Index(group.rows.size());
  const auto n =
      Eigen::Index(commands.columns.empty() ? arm.segments.size() : commands.columns.size());
  CommandTrack track;
  track.measured = commands.measured;
  track.values.resize(rows, n);
  const auto in_unit = [&](double logged, Eigen::Index column) {
    return commands.factor * (logged + commands.offset_of(column));
  };
  // Of two one-sided columns offsets are their sensors' zero; set points are signed.
  const auto setpoint_in_unit = [&](double logged, Eigen::Index column) {
    return commands.columns.empty() ? commands.factor * logged : in_unit(logged, column);
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    double right = std::numeric_limits<double>::quiet_NaN();
    double left = right;
    for (Eigen::Index r = 0; r < rows; ++r) {
      const std::size_t row = group.rows[std::size_t(r)];
      const auto read = [&](Eigen::Index column, double& value) {
        const double logged = table.columns[first + std::size_t(column)][row];
        // A set point holds over empty cells; of one signed column that is seen to later.
        const bool holds = !commands.measured && commands.columns.empty();
        if (!holds || std::isfinite(logged)) {
          value = in_unit(logged, i);
        }
      };
      read(i, right);
      if (commands.columns.empty()) {
        read(n + i, left);
        require_one_side(table, row, arm, i, right, left);
      }
      track.values(r, i) = commands.columns.empty() ? right - left : right;
    }
  }
  if (commands.setpoint.empty()) {
    return track;
  }
  const std::size_t begin = first + std::size_t(commands.columns.empty() ? 2 * n : n);
  track.setpoint.resize(rows, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index r = 0; r < rows; ++r) {
      track.setpoint(r, i) =
          setpoint_in_unit(table.columns[begin + std::size_t(i)][group.rows[std::size_t(r)]], i);
    }
  }
  if (commands.setpoint_optional && track.setpoint.array().isNaN().all()) {
    track.setpoint.resize(0, 0);
  }
  return track;
}

void take_repeated(const std::vector<std::size_t>& order, CommandTrack& track) {
  const auto take = [](Eigen::MatrixXd& matrix, Eigen::Index from, Eigen::Index to) {
    if (matrix.size() > 0) {
      const auto given = matrix.row(from).array().isFinite();
      matrix.row(to) = given.select(matrix.row(from), matrix.row(to)).eval();
    }
  };
  for (std::size_t row = 0; row < track.time_s.size(); ++row) {
    const auto kept = std::ranges::lower_bound(
        order, track.time_s[row], {}, [&](std::size_t other) { return track.time_s[other]; });
    // Of rows at one time the first is kept.
    if (kept == order.end() || *kept >= row || !(track.time_s[*kept] <= track.time_s[row])) {
      continue;
    }
    take(track.values, Eigen::Index(row), Eigen::Index(*kept));
    take(track.setpoint, Eigen::Index(row), Eigen::Index(*kept));
    if (!track.motion.empty() && std::isfinite(track.motion[row])) {
      track.motion[*kept] = track.motion[row];
    }
  }
}

std::vector<std::size_t> rows_in_order(const std::string& log, const std::vector<double>& time_s,
                                       RunReport& report) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (std::isfinite(time_s[i])) {
      order.push_back(i);
    } else {
      report.note("rows left out that have no time", fmt::format("{}: row {}", log, i));
    }
  }
  sort_rows(log, time_s, report, order);
  drop_repeated_rows(log, time_s, report, order);
  refuse_if(order.size() < 2,
            "{}: {} rows with a time of their own; expected a recording of at least a second", log,
            order.size());
  return order;
}

}  // namespace limber
