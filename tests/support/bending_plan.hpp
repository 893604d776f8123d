#pragma once

#include <utility>
#include <vector>

#include "limber/arm/no_load_model.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

/// Straight from each waypoint to the next, predicted by the no-load model.
inline Plan plan_through(const ArmDescription& arm, const Environment& environment,
                         std::vector<Pressures> waypoints_kpa) {
  const NoLoadModel model(arm);
  const auto frame = [&](const Pressures& setpoint_kpa) {
    PlanFrame result{setpoint_kpa, setpoint_kpa, Backbone(arm.point_count(), 3)};
    model.backbone(Eigen::Ref<const Eigen::VectorXf>(setpoint_kpa),
                   Eigen::Ref<Backbone>(result.backbone));
    return result;
  };
  Plan plan;
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash();
  plan.environment_name = environment.name;
  plan.environment_hash = environment_hash(environment);
  plan.frame_rate_hz = arm.frame_rate_hz;
  plan.waypoints_kpa = std::move(waypoints_kpa);
  plan.frames.push_back(frame(plan.waypoints_kpa.front()));
  for (std::size_t w = 1; w < plan.waypoints_kpa.size(); ++w) {
    const Pressures& from = plan.waypoints_kpa[w - 1];
    const Pressures& to = plan.waypoints_kpa[w];
    const int count = motion_frame_count(from, to, arm.pressure_step_limit_kpa());
    Pressures setpoint_kpa = from;
    for (int k = 1; k <= count; ++k) {
      motion_setpoint(from, to, k, count, setpoint_kpa);
      plan.frames.push_back(frame(setpoint_kpa));
    }
  }
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  return plan;
}

/// Bends both segments to the right by 80 kPa, one after the other.
inline Plan bending_plan(const ArmDescription& arm, const Environment& environment) {
  Pressures first = Pressures::Zero(2);
  first[0] = 80.0F;
  return plan_through(arm, environment, {Pressures::Zero(2), first, Pressures::Constant(2, 80.0F)});
}

}  // namespace limber
