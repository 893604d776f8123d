#pragma once
// For everyone.

#include <optional>

#include "limber/arm/backbone.hpp"

namespace limber {

inline constexpr double kDefaultOrientationToleranceRad = 0.3;

/// A region of end-effector poses in frame B. Without `theta_rad` any orientation will do.
/// Orientations are compared modulo a full turn: 1.2 and 1.2 − 2π ask for the same.
struct PoseGoal {
  double x_m = 0.0;
  double y_m = 0.0;
  std::optional<double> theta_rad = std::nullopt;
  double position_tolerance_m = 0.01;  ///< > 0
  /// > 0; unused without theta_rad
  double orientation_tolerance_rad = kDefaultOrientationToleranceRad;
};

/// How far a pose is from a goal's centre.
struct PoseError {
  double position_m = 0.0;
  double orientation_rad = 0.0;  ///< in [0, π]; 0 if the goal has no orientation
};

PoseError pose_error(const PoseGoal& goal, const Pose& pose);
/// Whether both errors are within the goal's tolerances.
bool is_within(const PoseGoal& goal, const PoseError& error);

}  // namespace limber
