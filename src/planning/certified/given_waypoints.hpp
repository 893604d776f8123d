#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "asked_problem.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// The plan along given waypoints, the start left out, if it is free, ends in the goal and is
/// certified; else why it is not.
PlanResult certified_along(const PlanningProblem& problem, AskedProblem& asked,
                           const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                           std::uint64_t seed);

}  // namespace limber
