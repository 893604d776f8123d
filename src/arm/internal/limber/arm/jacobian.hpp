#pragma once

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/arm/no_load_model.hpp"

namespace limber {

/// 3×n, one column per segment; storage is inside the object, so that solvers allocate nothing.
using PlanarJacobian =
    Eigen::Matrix<double, kPoseSize, Eigen::Dynamic, Eigen::ColMajor, kPoseSize, kMaxSegments>;
/// n numbers, stored inside the object.
using SegmentVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSegments, 1>;

/// dl/dκ in metre², the D of docs/model.md (6): the length a segment loses as it bends.
///
/// One-sided at κ = 0, where l has a kink: the sign of the zero chooses the side, +0.0 the
/// derivative towards positive curvature, −0.0 the one towards negative. @pre 0 ≤ segment < n.
double length_slope(const NoLoadModel& model, int segment, double curvature_per_m);

/// (7): spatial twist (v_x, v_y, ω) of one segment's end about the segment's base, per unit rate of
/// its curvature. v is the velocity of the body point that is just passing the base's origin, not
/// the velocity of the end. One-sided at κ = 0, as `length_slope`.
Eigen::Vector3d segment_twist(const NoLoadModel& model, int segment, double curvature_per_m);

/// Tip pose in frame B at given curvatures (size n, per metre, positive bends left).
Pose tip_at_curvatures(const NoLoadModel& model, const Eigen::Ref<const SegmentVector>& curvatures);

/// (8): twists (v_x, v_y, ω) of the end effector about the arm's base, column i per unit rate of
/// curvature i. `jacobian` becomes 3×n, `tip` the pose that belongs to it.
void spatial_jacobian(const NoLoadModel& model, const Eigen::Ref<const SegmentVector>& curvatures,
                      PlanarJacobian& jacobian, Pose& tip);

/// (13): velocity (ẋ, ẏ, θ̇) of the end effector itself, column i per unit rate of curvature i.
void tip_jacobian(const NoLoadModel& model, const Eigen::Ref<const SegmentVector>& curvatures,
                  PlanarJacobian& jacobian, Pose& tip);

}  // namespace limber
