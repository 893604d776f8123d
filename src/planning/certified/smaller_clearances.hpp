#pragma once

#include <chrono>

#include "asked_problem.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

using SteadyTime = std::chrono::steady_clock::time_point;

double seconds_since(SteadyTime start);

/// Where nothing was found that keeps the clearance asked for: names in `result` the largest with
/// which there is a plan, found with what `limits` leave of the time since `start`.
void try_smaller_clearances(const PlanningProblem& asked, AskedProblem& shared,
                            const PlannerLimits& limits, SteadyTime start, std::uint64_t seed,
                            const PlannerCallback& callback, PlanResult& result);

}  // namespace limber
