#pragma once
// For everyone.

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "limber/arm/pose_size.hpp"

namespace limber {

/// A pose in the plane. θ is unwrapped: poses are added up, never reduced by full turns.
template <class Scalar>
struct PoseOf {
  Scalar x_m = 0;
  Scalar y_m = 0;
  Scalar theta_rad = 0;
};
using Pose = PoseOf<double>;

// What follows is all of limber's planar arithmetic on single poses. The same equations stand,
// over many queries at once, in forward/row_kernels_impl.hpp, network/learnt_region.cpp and
// training's kernels; the certificate has a form of its own, so that it can't share a mistake.

/// The pose of kPoseSize numbers, such as a row of a backbone.
template <class Derived>
PoseOf<typename Derived::Scalar> pose_of(const Eigen::MatrixBase<Derived>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

template <class Scalar>
Eigen::Matrix<Scalar, kPoseSize, 1> numbers_of(const PoseOf<Scalar>& pose) {
  return {pose.x_m, pose.y_m, pose.theta_rad};
}

/// Where `step`, a pose about `from`, lies in the frame of `from`.
template <class Scalar>
PoseOf<Scalar> compose(const PoseOf<Scalar>& from, const PoseOf<Scalar>& step) {
  const Scalar c = std::cos(from.theta_rad);
  const Scalar s = std::sin(from.theta_rad);
  return {from.x_m + c * step.x_m - s * step.y_m, from.y_m + s * step.x_m + c * step.y_m,
          from.theta_rad + step.theta_rad};
}

/// The pose of `to` about `from`: compose(from, between(from, to)) is `to`.
template <class Scalar>
PoseOf<Scalar> between(const PoseOf<Scalar>& from, const PoseOf<Scalar>& to) {
  const Scalar x = to.x_m - from.x_m;
  const Scalar y = to.y_m - from.y_m;
  const Scalar c = std::cos(from.theta_rad);
  const Scalar s = std::sin(from.theta_rad);
  return {c * x + s * y, c * y - s * x, to.theta_rad - from.theta_rad};
}

/// (12): displacement along an arc that starts along x and turns by `angle_rad` over `length`: (x,
/// y) of its end. Series near zero; exact to rounding everywhere.
template <class Scalar>
Eigen::Matrix<Scalar, 2, 1> arc_end(Scalar length, Scalar angle_rad) {
  using std::abs;
  using std::cos;
  using std::sin;
  const Scalar square = angle_rad * angle_rad;
  // Below 0.1 rad the series' next term is 1e-15 relative.
  if (abs(angle_rad) < Scalar(0.1)) {
    const Scalar sine =
        Scalar(1) - square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72)));
    const Scalar versine =
        angle_rad / 2 *
        (1 - square / 12 * (1 - square / 30 * (1 - square / 56 * (1 - square / 90))));
    return {length * sine, length * versine};
  }
  return {length * sin(angle_rad) / angle_rad, length * (1 - cos(angle_rad)) / angle_rad};
}

/// The pose at the end of that arc, about its beginning.
template <class Scalar>
PoseOf<Scalar> arc(Scalar length, Scalar angle_rad) {
  const Eigen::Matrix<Scalar, 2, 1> end = arc_end(length, angle_rad);
  return {end[0], end[1], angle_rad};
}

/// Chord over length of an arc that turns by `angle_rad`, |angle_rad| < 2π.
inline double chord_share(double angle_rad) {
  const double half_rad = 0.5 * angle_rad;
  return half_rad == 0.0 ? 1.0 : std::sin(half_rad) / half_rad;
}

/// Poses of m points along the arm, one row (x_m, y_m, theta_rad) each, base first, end effector
/// last. Frame B (base): x along the straight arm, y left, θ counter-clockwise and unwrapped. Rows
/// are contiguous: the flat view of 3m numbers is what files and networks hold.
template <class Scalar>
using BackboneOf = Eigen::Matrix<Scalar, Eigen::Dynamic, kPoseSize, Eigen::RowMajor>;
using Backbone = BackboneOf<float>;
using BackboneD = BackboneOf<double>;

/// The same of an arm in space: one row (x_m, y_m, z_m, qx, qy, qz, qw) each; z up.
template <class Scalar>
using SpaceBackboneOf = Eigen::Matrix<Scalar, Eigen::Dynamic, kSpacePoseSize, Eigen::RowMajor>;
using SpaceBackbone = SpaceBackboneOf<float>;
using SpaceBackboneD = SpaceBackboneOf<double>;

/// One number per segment, gauge, signed: positive pressurises the right side and bends toward −y.
using Pressures = Eigen::VectorXf;

/// The last pose of a backbone (m×3, m ≥ 1).
template <class Derived>
Pose tip_pose(const Eigen::MatrixBase<Derived>& backbone) {
  return pose_of(backbone.template bottomRows<1>().template cast<double>());
}

/// Where the last pose of a backbone (m×3, m ≥ 1) is, x and y in frame B.
template <class Derived>
Eigen::Vector2d tip_position_m(const Eigen::MatrixBase<Derived>& backbone) {
  return backbone.template bottomRows<1>()
      .template leftCols<2>()
      .template cast<double>()
      .transpose();
}

/// How much of the room that is kept around it a plate has: less where it starts, since its place
/// is known there, and all of it from some distance on (docs/tube.md, (2)).
struct RoomGrowth {
  double start_share = 1.0;   ///< of its room that a plate has where it starts, in (0, 1]
  double full_after_m = 0.0;  ///< from this distance on it has all of it; 0: everywhere

  bool is_constant() const { return start_share >= 1.0 || full_after_m <= 0.0; }
  /// What is not finite has all of it.
  double share_after(double distance_m) const {
    return is_constant()
               ? 1.0
               : start_share + (1.0 - start_share) * std::min(1.0, distance_m / full_after_m);
  }
  bool operator==(const RoomGrowth&) const = default;
};

}  // namespace limber
