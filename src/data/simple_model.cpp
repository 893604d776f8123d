#include "limber/data/simple_model.hpp"

#include <cmath>

#include "limber/arm/no_load_model.hpp"

namespace limber {

namespace {

constexpr double kSmallTurn_rad = 1e-6;

/// Commands behind a first-order lag that begins settled.
Eigen::MatrixXd lagged_commands(const Episode& episode, double lag_s) {
  Eigen::MatrixXd commands = episode.pressure_kpa.cast<double>();
  for (Eigen::Index t = 1; lag_s > 0.0 && t < commands.rows(); ++t) {
    const double step_s = episode.time_s[t] - episode.time_s[t - 1];
    const double share = 1.0 - std::exp(-step_s / lag_s);
    commands.row(t) =
        (1.0 - share) * commands.row(t - 1) + share * episode.pressure_kpa.row(t).cast<double>();
  }
  return commands;
}

/// Chord over arc.
double chord_share(double turn_rad) {
  return std::abs(turn_rad) < kSmallTurn_rad ? 1.0 : std::sin(0.5 * turn_rad) / (0.5 * turn_rad);
}

}  // namespace

Eigen::MatrixXd lagged_turns(const ArmDescription& arm, const Episode& episode, double lag_s) {
  Eigen::MatrixXd turns = lagged_commands(episode, lag_s);
  if (arm.no_load == NoLoadKind::straight) {
    return turns;
  }
  const NoLoadModel no_load(arm);
  for (int i = 0; i < arm.segment_count(); ++i) {
    for (double& value : turns.col(i)) {
      const SegmentShape shape = no_load.segment_shape(i, value);
      value = shape.curvature_per_m * shape.length_m;
    }
  }
  return turns;
}

FrameMatrix predict(const SimpleModel& model, const ArmDescription& arm, const Episode& episode) {
  const NoLoadModel no_load(arm);
  const Eigen::MatrixXd commands = lagged_commands(episode, model.lag_s);
  const Eigen::MatrixXd turns = lagged_turns(arm, episode, model.lag_s);
  FrameMatrix poses = FrameMatrix::Zero(episode.frame_count(), 3 * arm.point_count());
  for (Eigen::Index t = 0; t < poses.rows(); ++t) {
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    Eigen::Index column = 3;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const SimpleSegment& segment = model.segments[at];
      const int gaps = arm.segments[at].gaps;
      const double turn_rad = (segment.gain * turns(t, i) + segment.offset_rad) / gaps;
      const double length_m = arm.no_load == NoLoadKind::straight
                                  ? arm.segments[at].length_m
                                  : no_load.segment_shape(i, commands(t, i)).length_m;
      const double chord_m = segment.length_ratio * length_m / gaps * chord_share(turn_rad);
      for (int gap = 0; gap < gaps; ++gap, column += 3) {
        const double middle_rad = pose[2] + 0.5 * turn_rad;
        pose += Eigen::Vector3d(chord_m * std::cos(middle_rad), chord_m * std::sin(middle_rad),
                                turn_rad);
        poses.row(t).segment<3>(column) = pose.transpose().cast<float>();
      }
    }
  }
  return poses;
}

}  // namespace limber
