#pragma once

#include "limber/arm/pose_size.hpp"
#include "limber/data/recording.hpp"

namespace limber {

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

}  // namespace limber
