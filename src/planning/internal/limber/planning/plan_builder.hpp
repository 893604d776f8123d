#pragma once

#include <string>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// A plan along waypoints, simulated from the start frame by frame, the hold included, with its
/// clearance and distance to the goal measured on those frames.
/// @param waypoints_kpa  start first
Plan build_plan(const PlanningProblem& problem, MotionSimulator& simulator,
                const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                std::uint64_t seed);

/// Whether a built plan keeps every constraint and ends in the goal.
bool is_solution(const PlanningProblem& problem, const CollisionChecker& checker, const Plan& plan);

}  // namespace limber
