#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "checked_plans.hpp"
#include "limber/run/plan_controller.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// Both errors of a pose as one length: the heading counts as much as the position if each is at
/// its tolerance.
double as_length_m(const PoseGoal& goal, const PoseError& error);

/// What a model is asked for to end in `goal`, if its tip misses by that much (x, y, heading).
PoseGoal asked_goal(PoseGoal goal, const Eigen::Vector3d& miss);

/// What is left of a plan for an arm in motion: the set points of its next frame, then the plan's
/// waypoints after that frame, its end last.
std::vector<Pressures> waypoints_after(const PlanProgress& at, double step_limit_kpa);

/// A checked plan from the problem's start along what is left of another, its end shifted, and the
/// waypoints before it in proportion to how far along they are, so that the tip comes to rest
/// nearer to the goal's centre. The model itself says what a shift does (finite differences, one
/// rollout per segment), then a few damped Newton steps are taken, each simulated. The nearest of
/// them that is free is the repair.
/// @param waypoints_kpa  the first one is kept
/// @param max_error_m  none if nothing free ends nearer (as_length_m)
std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check);

}  // namespace limber
