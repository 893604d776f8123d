#include "limber/arm/jacobian.hpp"

#include <cassert>
#include <cmath>

namespace limber {

namespace {

/// (a − sin a)/a² and (1 − cos a)/a², both smooth through zero.
struct ArcRates {
  double along = 0.0;
  double across = 0.0;
};

ArcRates arc_rates(double angle_rad) {
  const double square = angle_rad * angle_rad;
  // Below 0.1 rad the closed forms lose digits; the series' next terms are below 1e-15 relative.
  if (std::abs(angle_rad) < 0.1) {
    return {angle_rad / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0))),
            0.5 * (1.0 - square / 12.0 * (1.0 - square / 30.0 * (1.0 - square / 56.0)))};
  }
  return {(angle_rad - std::sin(angle_rad)) / square, (1.0 - std::cos(angle_rad)) / square};
}

/// Ad_T of a planar twist (v_x, v_y, ω), T the pose: v' = R v + ω (y, −x), ω' = ω.
Eigen::Vector3d adjoint(const Pose& pose, const Eigen::Vector3d& twist) {
  const double c = std::cos(pose.theta_rad);
  const double s = std::sin(pose.theta_rad);
  return {c * twist[0] - s * twist[1] + twist[2] * pose.y_m,
          s * twist[0] + c * twist[1] - twist[2] * pose.x_m, twist[2]};
}

}  // namespace

double length_slope(const NoLoadModel& model, int segment, double curvature_per_m) {
  if (model.kind() != NoLoadKind::strain_polynomial) {
    return 0.0;
  }
  const Segment& s = model.segment(segment);
  const double denominator = 2.0 + s.width_m * std::abs(curvature_per_m);
  const double magnitude = 2.0 * s.length_m * s.width_m / (denominator * denominator);
  return std::signbit(curvature_per_m) ? magnitude : -magnitude;
}

Eigen::Vector3d segment_twist(const NoLoadModel& model, int segment, double curvature_per_m) {
  const double length = model.length_for_curvature(segment, curvature_per_m);
  const double slope = length_slope(model, segment, curvature_per_m);
  const ArcRates rates = arc_rates(curvature_per_m * length);
  return {slope + length * length * rates.along, -length * length * rates.across,
          length + curvature_per_m * slope};
}

Pose tip_at_curvatures(const NoLoadModel& model,
                       const Eigen::Ref<const SegmentVector>& curvatures) {
  assert(curvatures.size() == model.segment_count());
  Pose pose;
  for (int i = 0; i < model.segment_count(); ++i) {
    const double length = model.length_for_curvature(i, curvatures[i]);
    pose = compose(pose, arc(length, curvatures[i] * length));
  }
  return pose;
}

void spatial_jacobian(const NoLoadModel& model, const Eigen::Ref<const SegmentVector>& curvatures,
                      PlanarJacobian& jacobian, Pose& tip) {
  assert(curvatures.size() == model.segment_count());
  jacobian.resize(kPoseSize, model.segment_count());
  tip = Pose{};
  for (int i = 0; i < model.segment_count(); ++i) {
    jacobian.col(i) = adjoint(tip, segment_twist(model, i, curvatures[i]));
    const double length = model.length_for_curvature(i, curvatures[i]);
    tip = compose(tip, arc(length, curvatures[i] * length));
  }
}

void tip_jacobian(const NoLoadModel& model, const Eigen::Ref<const SegmentVector>& curvatures,
                  PlanarJacobian& jacobian, Pose& tip) {
  spatial_jacobian(model, curvatures, jacobian, tip);
  // The twist's v belongs to the origin; the tip moves with v + ω × p.
  jacobian.row(0) -= tip.y_m * jacobian.row(2);
  jacobian.row(1) += tip.x_m * jacobian.row(2);
}

}  // namespace limber
