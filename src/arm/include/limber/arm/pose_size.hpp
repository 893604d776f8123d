#pragma once
// For everyone.

namespace limber {

/// Whether an arm moves in a plane or in space.
enum class Dimension { plane = 2, space = 3 };

/// Numbers per planar pose, and so per plate of a planar shape: x_m, y_m, theta_rad.
inline constexpr int kPoseSize = 3;
/// Numbers per pose in space: x_m, y_m, z_m, qx, qy, qz, qw.
inline constexpr int kSpacePoseSize = 7;
/// Numbers of a gap in space: where the next plate lies in the frame of the plate before (x_m, y_m,
/// z_m), and the rotation vector between them (rad).
inline constexpr int kSpaceGapSize = 6;

constexpr int pose_size(Dimension dimension) {
  return dimension == Dimension::plane ? kPoseSize : kSpacePoseSize;
}
/// Numbers that say where a plate is: x, y and, in space, z. They come first in a pose.
constexpr int position_size(Dimension dimension) {
  return int(dimension);
}
/// Numbers of a plate's pose about the plate before it.
constexpr int gap_size(Dimension dimension) {
  return dimension == Dimension::plane ? kPoseSize : kSpaceGapSize;
}

}  // namespace limber
