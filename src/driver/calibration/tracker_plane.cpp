#include "limber/driver/tracker_plane.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace limber {

namespace {

/// Rot(z, θ), and what tilts it: the body's rotation in the plane's axes, its own taken off.
Eigen::Quaterniond turn_in_plane(const TrackerPlane& plane, const BodyPoses& bodies,
                                 Eigen::Index body) {
  return plane.axes().conjugate() * rotation_of(bodies, body) *
         plane.body_rotations[static_cast<std::size_t>(body)].conjugate();
}

}  // namespace

Eigen::Quaterniond rotation_of(const BodyPoses& bodies, Eigen::Index body) {
  return {bodies(body, 6), bodies(body, 3), bodies(body, 4), bodies(body, 5)};
}

Eigen::Quaterniond TrackerPlane::axes() const {
  Eigen::Matrix3d columns;
  columns << x_axis, y_axis, normal();
  return Eigen::Quaterniond(columns);
}

Backbone poses_in_plane(const TrackerPlane& plane, const BodyPoses& bodies) {
  assert(bodies.rows() == static_cast<Eigen::Index>(plane.body_rotations.size()));
  Backbone poses(bodies.rows(), kPoseSize);
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Eigen::Vector3d from_origin = bodies.row(i).head<3>().transpose() - plane.origin;
    // The turn about z that is nearest to a rotation (w, x, y, z): 2 atan2(z, w).
    const Eigen::Quaterniond turn = turn_in_plane(plane, bodies, i);
    const double theta_rad =
        std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * std::numbers::pi);
    poses.row(i) << static_cast<float>(from_origin.dot(plane.x_axis)),
        static_cast<float>(from_origin.dot(plane.y_axis)), static_cast<float>(theta_rad);
  }
  return poses;
}

Eigen::VectorXd tilts_rad(const TrackerPlane& plane, const BodyPoses& bodies) {
  Eigen::VectorXd tilts(bodies.rows());
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Eigen::Quaterniond turn = turn_in_plane(plane, bodies, i);
    tilts[i] = 2.0 * std::atan2(std::hypot(turn.x(), turn.y()), std::hypot(turn.z(), turn.w()));
  }
  return tilts;
}

BodyPoses bodies_in_space(const TrackerPlane& plane, const Backbone& poses,
                          const Eigen::VectorXd& heights) {
  assert(poses.rows() == static_cast<Eigen::Index>(plane.body_rotations.size()));
  BodyPoses bodies(poses.rows(), 7);
  for (Eigen::Index i = 0; i < poses.rows(); ++i) {
    const Eigen::Vector3d position = plane.origin + double(poses(i, 0)) * plane.x_axis +
                                     double(poses(i, 1)) * plane.y_axis +
                                     heights[i] * plane.normal();
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(double(poses(i, 2)), Eigen::Vector3d::UnitZ()));
    const Eigen::Quaterniond rotation =
        plane.axes() * turn * plane.body_rotations[static_cast<std::size_t>(i)];
    bodies.row(i) << position.transpose(), rotation.coeffs().transpose();  // x, y, z, w
  }
  return bodies;
}

}  // namespace limber
