#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limber/driver/calibration_log.hpp"
#include "seen_poses.hpp"

namespace limber {

/// Mean positions and rotations of bodies in 3D, in the tracker's frame and unit, and how many
/// frames they are of.
struct MeanBodies {
  Eigen::MatrixX3d position;
  std::vector<Eigen::Quaterniond> rotation;
  int count = 0;

  Eigen::Index bodies() const { return position.rows(); }
};

/// Over frames `first` to `end` − 1. A mean rotation is the one nearest to all, in least squares of
/// quaternions, whose signs do not count.
/// @throws CalibrationRefused where fewer than three are seen.
MeanBodies mean_bodies(const CalibrationLog& log, std::size_t first, std::size_t end,
                       const char* when);

/// As PulsePoses, over the same frames.
struct PulseBodies {
  MeanBodies before, held, after;
};
std::vector<PulseBodies> pulse_bodies(const CalibrationLog& log, double frame_period_s);

/// Axis times angle, [rad], of the rotation that turns `body` from one to the other.
Eigen::Vector3d turn_between(const MeanBodies& from, const MeanBodies& to, Eigen::Index body);

/// Standard deviations of one frame along and about each axis, from what changes between
/// neighbouring frames at rest.
struct BodyNoise {
  double position = 0.0;
  double rotation_rad = 0.0;
};
BodyNoise body_noise(const CalibrationLog& log, std::size_t first, std::size_t end);

}  // namespace limber
