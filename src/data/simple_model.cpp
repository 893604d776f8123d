#include "limber/data/simple_model.hpp"

#include <cmath>

#include "limber/arm/no_load_model.hpp"

namespace limber {

namespace {

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
  FrameMatrix poses = FrameMatrix::Zero(episode.frame_count(), kPoseSize * arm.point_count());
  for (Eigen::Index t = 0; t < poses.rows(); ++t) {
    Pose pose;
    Eigen::Index column = kPoseSize;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const SimpleSegment& segment = model.segments[at];
      const int gaps = arm.segments[at].gaps;
      const double turn_rad = (segment.gain * turns(t, i) + segment.offset_rad) / gaps;
      const double length_m = arm.no_load == NoLoadKind::straight
                                  ? arm.segments[at].length_m
                                  : no_load.segment_shape(i, commands(t, i)).length_m;
      const Pose step = arc(segment.length_ratio * length_m / gaps, turn_rad);
      for (int gap = 0; gap < gaps; ++gap, column += kPoseSize) {
        pose = compose(pose, step);
        poses.row(t).segment<kPoseSize>(column) = numbers_of(pose).cast<float>();
      }
    }
  }
  return poses;
}

}  // namespace limber
