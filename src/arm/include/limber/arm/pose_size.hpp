#pragma once
// For everyone.

namespace limber {

/// Numbers per pose, and so per plate of a shape: x_m, y_m, theta_rad.
inline constexpr int kPoseSize = 3;

}  // namespace limber
