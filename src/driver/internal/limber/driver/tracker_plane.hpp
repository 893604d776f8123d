#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limber/arm/backbone.hpp"

namespace limber {

/// Marker bodies seen in 3D, one row (x, y, z, qx, qy, qz, qw) each, base first, in the tracker's
/// own frame and unit. The unit quaternion turns the body's own axes into the tracker's.
using BodyPoses = Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>;

/// The last four numbers of a row.
Eigen::Quaterniond rotation_of(const BodyPoses& bodies, Eigen::Index body);

/// The plane in which an arm moves, in the frame of a tracker that sees bodies in 3D. A body at
/// (x, y, θ) in the plane and at height h above it is at origin + x·x_axis + y·y_axis + h·normal,
/// and turned by F · Rot(z, θ) · M, with the axes (x_axis, y_axis, normal) as F's columns and M the
/// body's own rotation. Each body keeps its height.
struct TrackerPlane {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< in the tracker's unit
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();  ///< of length 1
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();  ///< of length 1, perpendicular to x_axis
  std::vector<Eigen::Quaterniond> body_rotations;     ///< M of each body
  double out_of_plane_m = 0.0;  ///< how far a body's height changed at most, while calibrating
  double tilt_rad = 0.0;        ///< how far one turned out of the plane at most

  Eigen::Vector3d normal() const { return x_axis.cross(y_axis); }
  /// F as a rotation.
  Eigen::Quaterniond axes() const;
};

/// (x, y, θ) of each body in the plane, lengths in the tracker's unit, θ in rad and within half a
/// turn. Heights and tilts are left out. @pre as many bodies as `body_rotations`
Backbone poses_in_plane(const TrackerPlane& plane, const BodyPoses& bodies);

/// How far each body is turned out of the plane, [rad] from 0 to π. @pre as above
Eigen::VectorXd tilts_rad(const TrackerPlane& plane, const BodyPoses& bodies);

/// The inverse of `poses_in_plane`. @param heights  of each body, in the tracker's unit
BodyPoses bodies_in_space(const TrackerPlane& plane, const Backbone& poses,
                          const Eigen::VectorXd& heights);

}  // namespace limber
