#pragma once
// For everyone.

#include <algorithm>

#include <Eigen/Core>

#include "limber/arm/pose.hpp"

namespace limber {

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
