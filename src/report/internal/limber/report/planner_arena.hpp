#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limber/run/plan_trial.hpp"

namespace limber {

/// The trials in one environment as a log of OMPL's benchmarks, which Planner Arena and OMPL's own
/// script (ompl_benchmark_statistics.py) read: one planner for each of limber's planners and
/// models.
/// @param environment  EnvironmentCase::id
std::string planner_arena_log(const std::string& environment, const std::vector<PlanTrial>& trials,
                              const PlannerLimits& limits, std::uint64_t seed);

}  // namespace limber
