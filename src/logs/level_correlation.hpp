#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "log_rows.hpp"

namespace limber {

/// By how much each segment turns, over a log's own times. The times are borrowed from the track.
/// In space a segment has two columns, about y and about z.
struct Turns {
  const std::vector<double>& time_s;
  Eigen::MatrixXd values;  ///< T×n, in space T×2s [rad], NaN where unknown
  bool held = false;       ///< set points: in force until the next row

  /// On the straight line between the rows around `time_s`, or held; NaN outside of them, or beside
  /// a NaN.
  double at(double time_s, Eigen::Index column) const;
};

/// Seen: heading of each segment's last plate less that of its first.
Turns turns_of(const BackboneTrack& motion, const ArmDescription& arm);

/// Told: what the no-load model makes of the commands; where that is straight, the commands.
Turns turns_of(const CommandTrack& commands, const ArmDescription& arm);

inline constexpr double kLevelRate_hz = 10.0;

/// What a log's segments turned by and what its columns said, on one clock, at that rate. Levels,
/// not rates: friction and lag change how a segment gets somewhere more than where it gets.
struct LevelTable {
  Eigen::MatrixXd turn_rad;            ///< T×n, positive to the left
  Eigen::MatrixXd command;             ///< T×n (T×M before sums), as the log has it
  std::vector<Eigen::Index> run_ends;  ///< row behind the last of each run; rows don't go on there

  Eigen::Index row_count() const { return turn_rad.rows(); }
};

/// Rows in which everything is known, where both tracks reach.
LevelTable levels_of(const BackboneTrack& motion, const CommandTrack& commands,
                     const ArmDescription& arm);

/// Puts the rows of another run behind those that are there.
void append(LevelTable& levels, const LevelTable& more);

/// Σ_t a(t) b(t − s) for every shift s from 1 − |b| to |a| − 1, at index s + |b| − 1.
/// @pre neither is empty
Eigen::VectorXd cross_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// How the levels of every segment go with every column.
struct LevelCorrelations {
  Eigen::MatrixXd correlation;  ///< n×n, segment × column, in [−1, 1]; 0 where one stands still
  /// n×n [nats], ≥ 0: how much better a line in the column explains the segment's turn than a
  /// constant does, −½ (N − 3) log(1 − r²). N counts independent rows: T over the time in which
  /// both forget where they were (Bartlett).
  Eigen::MatrixXd evidence;
  Eigen::MatrixXd independent_rows;  ///< n×n, that N; 0 where one stands still
  std::vector<bool> turned;          ///< n: the segment turned by more than a tracker's noise
  std::vector<bool> changed;  ///< n: the column changed by more than 2 % of the segment's limit
};

LevelCorrelations correlate_levels(const LevelTable& levels, const ArmDescription& arm);

}  // namespace limber
