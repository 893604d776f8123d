#pragma once

#include "limber/arm/no_load_model.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// An arm that bends by that share of what it did. @pre linear strain polynomials
inline ArmDescription bending(ArmDescription arm, double share) {
  for (Segment& segment : arm.segments) {
    segment.strain_polynomial[0] *= share;
  }
  return arm;
}

/// 5 kPa per frame.
inline ArmDescription slow(ArmDescription arm) {
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  return arm;
}

inline Backbone unloaded_shape(const ArmDescription& arm, const Pressures& kpa) {
  Backbone shape(arm.point_count(), 3);
  NoLoadModel(arm).backbone(Eigen::Ref<const Eigen::VectorXf>(kpa), Eigen::Ref<Backbone>(shape));
  return shape;
}

/// Within 2 cm of where the unloaded arm's tip is then.
inline PoseGoal goal_at(const ArmDescription& arm, const Pressures& kpa) {
  const Pose there = tip_pose(unloaded_shape(arm, kpa));
  return {there.x_m, there.y_m, std::nullopt, 0.02, 0.1};
}

}  // namespace limber
