#pragma once

#include "limber/world/plan.hpp"
#include "limber/world/straight_motion.hpp"
#include "planning/random_shapes.hpp"

namespace limber {

/// A plan of awkward numbers that keeps every rule: 4 moving frames, 2 of holding.
inline Plan small_plan(const ArmDescription& arm) {
  const NoLoadModel model(arm);
  RandomStream random(4, 0);
  Plan plan;
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash();
  plan.model = "network";
  plan.model_hash = "abc";
  plan.valves_hash = "fed";
  plan.environment_name = "e";
  plan.environment_hash = "def";
  plan.planner = "paper";
  plan.seed = 0xFFFFFFFFFFFFFFFFULL;
  plan.frame_rate_hz = arm.frame_rate_hz;
  plan.clearance_m = 0.1 / 3.0;
  plan.goal_distance_m = 1e-3 / 7.0;
  plan.program_version = "0.1.0";
  Pressures q = Pressures::Zero(arm.segment_count());
  for (int k = 0; k < 5; ++k) {
    plan.frames.push_back({q, 0.9F * q, no_load_backbone(model, q)});
    for (int i = 0; i < q.size(); ++i) {
      q[i] += static_cast<float>(random.uniform(-4.9, 4.9));
    }
  }
  plan.frames.push_back(plan.frames.back());
  plan.frames.push_back(plan.frames.back());
  plan.hold_frame_count = 2;
  plan.waypoints_kpa = {plan.frames.front().setpoint_kpa, plan.frames.back().setpoint_kpa};
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  return plan;
}

}  // namespace limber
