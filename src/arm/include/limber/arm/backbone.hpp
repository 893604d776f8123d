#pragma once
// For everyone.

#include <Eigen/Core>

namespace limber {

/// Poses of m points along the arm, one row (x_m, y_m, theta_rad) each, base first, end effector
/// last. Frame B (base): x along the straight arm, y left, θ counter-clockwise and unwrapped. Rows
/// are contiguous: the flat view of 3m numbers is what files and networks hold.
template <class Scalar>
using BackboneOf = Eigen::Matrix<Scalar, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Backbone = BackboneOf<float>;
using BackboneD = BackboneOf<double>;

/// One number per segment, gauge, signed: positive pressurises the right side and bends toward −y.
using Pressures = Eigen::VectorXf;

/// A pose in the plane.
struct Pose {
  double x_m = 0.0;
  double y_m = 0.0;
  double theta_rad = 0.0;
};

template <class Scalar>
Pose tip_pose(const Eigen::MatrixBase<BackboneOf<Scalar>>& backbone) {
  const auto last = backbone.row(backbone.rows() - 1);
  return {double(last[0]), double(last[1]), double(last[2])};
}

}  // namespace limber
