#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_table.hpp"

namespace limber {

inline constexpr double kShortestChord = 0.2;  // over the length at rest; an arc of 4.6 rad has it

/// Where a log saw points of an arm, in one plane and on the log's own clock. T rows, k points; NaN
/// where a point was not tracked. Metres, radians, seconds; the frame is the log's own until
/// `align_base`.
struct PointTracks {
  std::vector<std::string> names;  ///< k, base first; what messages call them
  std::vector<int> plates;         ///< k, rising: which plate of the arm each is, 0 the base
  std::vector<double> time_s;      ///< T
  Eigen::MatrixXd x_m;             ///< T×k
  Eigen::MatrixXd y_m;             ///< T×k
  Eigen::MatrixXd theta_rad;       ///< T×k, wrapped or not; 0×0 if only positions were logged

  int point_count() const { return int(plates.size()); }
  Eigen::Index row_count() const { return Eigen::Index(time_s.size()); }
  bool has_headings() const { return theta_rad.size() > 0; }
  bool is_tracked(Eigen::Index t, Eigen::Index i) const {
    return std::isfinite(x_m(t, i)) && std::isfinite(y_m(t, i)) &&
           (!has_headings() || std::isfinite(theta_rad(t, i)));
  }
  /// Of the line from point `a` to point `b`.
  double direction_rad(Eigen::Index t, Eigen::Index a, Eigen::Index b) const {
    return std::atan2(y_m(t, b) - y_m(t, a), x_m(t, b) - x_m(t, a));
  }
};

/// Commands (pressures, or what the arm file says) in the arm's unit on the log's own clock; NaN
/// where a cell was empty. One column for each segment or, until `sum_commands`, for each of the
/// arm file's `commands`.
struct CommandTrack {
  std::vector<double> time_s;  ///< T
  Eigen::MatrixXd values;      ///< T×n, signed: measured, or the set points if nothing was
  bool measured = true;
  Eigen::MatrixXd setpoint;    ///< T×n, or 0×0 if none were logged beside what was measured
  std::vector<double> motion;  ///< T numbers of motions, or empty

  Eigen::Index row_count() const { return Eigen::Index(time_s.size()); }
};

/// The whole backbone on the motion log's clock, every plate of the arm, in frame B. T rows.
struct BackboneTrack {
  std::vector<double> time_s;  ///< T, increasing
  Eigen::MatrixXd poses;       ///< T×3m: x_m, y_m, theta_rad of each plate; θ unwrapped; in space
                               ///< T×7m, quaternions without jumps of sign
  std::vector<bool> tracked;   ///< T; false if a point was missing for too long: poses are NaN
  std::vector<bool> bridged;   ///< T; a point of this row was put between its neighbours in time
  double usual_step_s = 0.0;   ///< between rows, by kUsualSteps; 0: the median step

  Eigen::Index row_count() const { return Eigen::Index(time_s.size()); }
};

/// Keeps these rows, in this order; what is empty stays empty.
void keep_rows(std::vector<double>& values, const std::vector<std::size_t>& order);
void keep_rows(Eigen::MatrixXd& matrix, const std::vector<std::size_t>& order);
void keep_rows(PointTracks& tracks, const std::vector<std::size_t>& order);
void keep_rows(CommandTrack& track, const std::vector<std::size_t>& order);

/// Which rows of a table belong to one recording.
struct RowGroup {
  std::string label;
  std::vector<std::size_t> rows;
};

/// By the table's labels, in the order of first appearance; one group where it has none.
std::vector<RowGroup> group_rows(const LogTable& table);

/// Those rows of a column, times `factor`.
std::vector<double> picked(const std::vector<double>& column, const std::vector<std::size_t>& rows,
                           double factor);

/// In which rows of a group a point is hidden, as some trackers write it: all of its cells are
/// zero, or its place is and its quaternion is the identity, and in most others it is elsewhere. A
/// base is where it is in half of all rows. Each is noted.
/// @param first  its first column, x; y follows, and z in space; `cells` are its columns in all
std::vector<bool> rows_of_zeros(const LogTable& table, const RowGroup& group, std::size_t first,
                                std::size_t cells, const PointSource& point,
                                const ImportMapping& mapping, RunReport& report);

/// Adds the command columns in the order that `commands_of` reads them.
void want_commands(const CommandColumns& commands, WantedColumns& wanted);

/// Commands in the arm's unit, without times. @param first  the table's first command column
CommandTrack commands_of(const LogTable& table, std::size_t first, const RowGroup& group,
                         const ImportMapping& mapping, const ArmDescription& arm);

/// Rows that are kept get what later rows of the same time say: each of them may have set points of
/// its own, and the last one given is in force. @param order  as `rows_in_order` has it
void take_repeated(const std::vector<std::size_t>& order, CommandTrack& track);

/// The rows to keep, in the order of time (log_runs.hpp, put_in_order).
std::vector<std::size_t> rows_in_order(const std::string& log, const std::vector<double>& time_s,
                                       RunReport& report);

}  // namespace limber
