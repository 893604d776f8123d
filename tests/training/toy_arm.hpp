#pragma once

#include <algorithm>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// A toy arm with memory: the no-load model at pressures that lag behind by a play operator, as dry
/// friction makes them. Its next backbone follows from (q_t, B_{t−1}), so a network can learn it.
inline Episode toy_episode(const ArmDescription& arm, int motions, int frames_per_motion,
                           std::uint64_t seed, float play_kpa = 15.0F) {
  const int n = arm.segment_count();
  const int frames = motions * frames_per_motion + 1;
  const NoLoadModel no_load(arm);
  Episode episode;
  episode.time_s.setLinSpaced(frames, 0.0, (frames - 1) * arm.frame_period_s());
  episode.pressure_kpa.setZero(frames, n);
  episode.setpoint_kpa.setZero(frames, n);
  episode.backbone.setZero(frames, 3 * arm.point_count());
  episode.motion_index.assign(static_cast<std::size_t>(frames), 0);
  RandomStream random(seed, 0);
  Pressures goal = Pressures::Zero(n);
  Pressures current = Pressures::Zero(n);
  Pressures felt = Pressures::Zero(n);
  Backbone backbone(arm.point_count(), 3);
  for (int t = 0; t < frames; ++t) {
    if (t > 0 && (t - 1) % frames_per_motion == 0) {
      for (int i = 0; i < n; ++i) {
        const double limit =
            arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa();
        goal[i] = static_cast<float>(random.uniform(-limit, limit));
      }
    }
    const float step = 5.0F;
    current += (goal - current).cwiseMax(-step).cwiseMin(step);
    felt = felt.cwiseMax((current.array() - play_kpa).matrix())
               .cwiseMin((current.array() + play_kpa).matrix())
               .eval();
    no_load.backbone(felt, backbone);
    episode.pressure_kpa.row(t) = current.transpose();
    episode.setpoint_kpa.row(t) = goal.transpose();
    episode.backbone.row(t) = backbone.reshaped<Eigen::RowMajor>().transpose();
    episode.motion_index[static_cast<std::size_t>(t)] = std::max(0, (t - 1) / frames_per_motion);
  }
  return episode;
}

inline ArmDescription three_segment_arm() {
  return load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
}

}  // namespace limber
