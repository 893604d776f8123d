#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// A motion along waypoints, simulated from the start frame by frame, including the hold, with its
/// distance to the goal measured on its last frame. Its clearance is not measured.
/// @param waypoints_kpa  start first
Plan build_partial_plan(const PlanningProblem& problem, MotionSimulator& simulator,
                        const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                        std::uint64_t seed);

/// The same with its clearance, over all frames and between them.
/// @param give_up  called at every frame; once it is true, the clearance is that of the frames so
///                 far. Empty: never
Plan build_plan(const PlanningProblem& problem, MotionSimulator& simulator,
                const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                std::uint64_t seed, const std::function<bool()>& give_up = {});

/// Why a built plan is no solution: its first frame that is not free, or where it ends. Empty: it
/// keeps every constraint and ends in the goal.
std::string why_no_solution(const PlanningProblem& problem, const CollisionChecker& checker,
                            const Plan& plan);

}  // namespace limber
