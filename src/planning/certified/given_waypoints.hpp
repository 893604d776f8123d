#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "asked_problem.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// The plan along given waypoints, the start left out, if it is free, ends in the goal and is
/// certified; else why it is not.
PlanResult certified_along(const PlanningProblem& problem, AskedProblem& asked,
                           const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                           std::uint64_t seed);

using SteadyTime = std::chrono::steady_clock::time_point;

/// If nothing was found that keeps the clearance asked for: names in `result` the largest clearance
/// with which there is a plan. Its tries share what the limits' patience keeps back, as far as the
/// search, begun at `start`, has left it.
void try_smaller_clearances(Planner& planner, const PlanningProblem& asked, AskedProblem& shared,
                            const PlannerLimits& limits, SteadyTime start, std::uint64_t seed,
                            const PlannerCallback& callback, PlanResult& result);

}  // namespace limber
