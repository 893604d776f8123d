#include "limber/planning/plan_builder.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/units.hpp"
#include "limber/common/version.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/world/pose_goal.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

PoseError final_error(const PlanningProblem& problem, const Plan& plan) {
  return pose_error(problem.environment.goal, tip_pose(plan.frames.back().backbone));
}

/// Smallest clearance over all frames and between them, of the tube if there is one; the margin
/// given back.
double plan_clearance_m(const CollisionChecker& checker, double margin_m, const Plan& plan,
                        const std::function<bool()>& give_up) {
  double smallest = checker.clearance(plan.frames.front().backbone).value_m;
  for (std::size_t k = 1; k < plan.frames.size() && !(give_up && give_up()); ++k) {
    smallest =
        checker.motion_clearance(plan.frames[k - 1].backbone, plan.frames[k].backbone, smallest)
            .value_m;
  }
  return smallest + margin_m;
}

/// @param clearance  less than none, of the motion to frame `k`
std::string why_not_free(const PlanningProblem& problem, std::size_t k,
                         const Clearance& clearance) {
  // A shape that is none is no nearer to one obstacle than to another, and there may be none.
  if (clearance.obstacle < 0 || !std::isfinite(clearance.value_m)) {
    return fmt::format("the model predicts a shape that no arm has in {}", frame_name(k));
  }
  return fmt::format("the motion to {} is {:.2f} cm short of the clearance from {}, {}",
                     frame_name(k), -clearance.value_m * kCmPerM,
                     obstacle_name(problem.environment, clearance.obstacle),
                     gap_name(problem.arm, clearance.gap));
}

}  // namespace

Plan build_partial_plan(const PlanningProblem& problem, MotionSimulator& simulator,
                        const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                        std::uint64_t seed) {
  Plan plan;
  const ArmIdentity arm = identity_of(problem.arm);
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash;
  plan.arm_description = arm.description;
  plan.command = problem.arm.command;
  plan.model = problem.model.has_network() ? "network" : "no_load";
  plan.valves_hash = problem.model.valves().parameters().hash();
  plan.environment_name = problem.environment.name;
  if (problem.judge == nullptr) {
    plan.environment_hash = environment_hash(problem.environment);
  }
  plan.planner = planner;
  plan.seed = seed;
  plan.margin_m = problem.margin_m;
  plan.tube = problem.tube;
  plan.frame_rate_hz = problem.arm.frame_rate_hz;
  plan.limits = problem.limits;
  plan.program_version = version();
  plan.waypoints_kpa = waypoints_kpa;
  const ArmStart start = start_state(problem.environment, problem.arm);
  plan.frames.push_back({waypoints_kpa.front(), start.pressures_kpa, start.backbone});
  const bool was_interrupted = interrupt_requested();  // then this is what is left to be done
  for (std::size_t w = 1; w < waypoints_kpa.size(); ++w) {
    if (!was_interrupted) {
      throw_if_interrupted();
    }
    simulator.append_motion(waypoints_kpa[w], plan.frames, &start);
  }
  plan.hold_frame_count = simulator.append_hold(plan.frames, &start);
  plan.cost_kpa = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  const PoseError error = final_error(problem, plan);
  plan.goal_distance_m = error.position_m;
  plan.goal_orientation_rad = error.orientation_rad;
  return plan;
}

Plan build_plan(const PlanningProblem& problem, MotionSimulator& simulator,
                const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                std::uint64_t seed, const std::function<bool()>& give_up) {
  Plan plan = build_partial_plan(problem, simulator, waypoints_kpa, planner, seed);
  plan.clearance_m = plan_clearance_m(simulator.checker(), problem.margin_m, plan, give_up);
  return plan;
}

std::string why_no_solution(const PlanningProblem& problem, const CollisionChecker& checker,
                            const Plan& plan) {
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    const Backbone& before = plan.frames[k - 1].backbone;
    const Backbone& after = plan.frames[k].backbone;
    if (!checker.is_motion_free(before, after)) {
      return why_not_free(problem, k, checker.motion_clearance(before, after, kMaxMarginM));
    }
  }
  if (is_within(problem.environment.goal, final_error(problem, plan))) {
    return "";
  }
  return fmt::format("it ends {:.2f} cm and {:.3f} rad from the goal's centre, outside of the goal",
                     plan.goal_distance_m * kCmPerM, plan.goal_orientation_rad);
}

}  // namespace limber
