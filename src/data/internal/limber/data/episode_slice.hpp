#pragma once

#include <cstdint>
#include <vector>

#include "limber/arm/pose_size.hpp"
#include "limber/common/mapped.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Frames [first, first + count) as an episode of their own.
inline Episode slice(const Episode& episode, int first, int count) {
  Episode part;
  part.time_s = episode.time_s.segment(first, count);
  part.pressure_kpa = episode.pressure_kpa.middleRows(first, count);
  part.setpoint_kpa = episode.setpoint_kpa.middleRows(first, count);
  part.setpoints_only = episode.setpoints_only;
  part.dimension = episode.dimension;
  part.lifted = episode.lifted;
  part.physics = episode.physics;
  part.log = episode.log;
  part.backbone = episode.backbone.middleRows(first, count);
  part.motion_index.assign(episode.motion_index.begin() + first,
                           episode.motion_index.begin() + first + count);
  if (!episode.tracked.empty()) {
    part.tracked.assign(episode.tracked.begin() + first, episode.tracked.begin() + first + count);
  }
  return part;
}

/// The same motion of the arm's mirror image, left for right: every pressure and set point, y and θ
/// change their sign. That arm is another one: its sides have changed places, and its table tilts
/// the other way. So its `physics` is not known.
inline Episode mirrored(Episode episode) {
  episode.pressure_kpa *= -1.0F;
  episode.setpoint_kpa *= -1.0F;
  for (Eigen::Index column = 0; column < episode.backbone.cols(); ++column) {
    if (column % kPoseSize != 0) {
      episode.backbone.col(column) *= -1.0F;
    }
  }
  episode.physics.clear();
  return episode;
}

/// Numbers of the frames in which the arm was tracked.
inline std::vector<int> tracked_frames(const Episode& episode) {
  std::vector<int> frames;
  for (int t = 0; t < episode.frame_count(); ++t) {
    if (episode.was_tracked(t)) {
      frames.push_back(t);
    }
  }
  return frames;
}

/// Of all of them together.
inline std::int64_t frame_count(const std::vector<Episode>& episodes) {
  return sum_of<std::int64_t>(episodes,
                              [&](const Episode& episode) { return episode.frame_count(); });
}

/// Frames in which the arm was tracked.
inline std::int64_t tracked_count(const std::vector<Episode>& episodes) {
  return sum_of<std::int64_t>(episodes, [&](const Episode& episode) {
    return episode.frame_count() - episode.untracked_count();
  });
}

}  // namespace limber
