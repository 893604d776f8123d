#pragma once

#include <cmath>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/recording.hpp"

namespace limber::testing_support {

/// The unloaded arm behind a lag of a fifth of a second and `late` frames of dead time, its first
/// segment bent `bends` times as much as the file says.
inline Episode space_toy_episode(const ArmDescription& arm, int frames, std::uint64_t seed,
                                 int late = 0, double bends = 1.1) {
  RandomStream random(seed, 1);
  Episode episode;
  episode.dimension = Dimension::space;
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) * arm.frame_period_s());
  episode.setpoint_kpa.resize(frames, arm.channel_count());
  episode.backbone.resize(frames, kSpacePoseSize * arm.point_count());
  episode.motion_index.assign(static_cast<std::size_t>(frames), 0);
  Eigen::RowVectorXf goal = Eigen::RowVectorXf::Zero(arm.channel_count());
  Eigen::VectorXf behind = goal.transpose();
  ArmDescription bent = arm;
  for (Chamber& chamber : bent.segments[0].chambers) {
    chamber.strain_polynomial[0] *= bends;
  }
  const NoLoadModel no_load(bent);
  const float open = 1.0F - std::exp(-float(arm.frame_period_s()) / 0.2F);
  for (int t = 0; t < frames; ++t) {
    if (t % 25 == 1) {
      goal = Eigen::RowVectorXf::NullaryExpr(arm.channel_count(),
                                             [&] { return float(random.uniform(0.0, 80.0)); });
    }
    episode.setpoint_kpa.row(t) = goal;
    const Eigen::VectorXf asked = episode.setpoint_kpa.row(std::max(t - late, 0)).transpose();
    behind += open * (asked - behind);
    Eigen::VectorXf poses(episode.backbone.cols());
    no_load.poses(behind, poses);
    episode.backbone.row(t) = poses.transpose();
  }
  episode.pressure_kpa = episode.setpoint_kpa;
  return episode;
}

}  // namespace limber::testing_support
