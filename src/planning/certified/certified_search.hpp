#pragma once

#include "asked_problem.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// Plans `problem` with `planner` and a little less room, and certifies it as it was asked for.
/// @param asked  the same arm, model and environment, whatever their margins
PlanResult certified_search(Planner& planner, const PlanningProblem& problem, AskedProblem& asked,
                            const PlannerLimits& limits, std::uint64_t seed,
                            const PlannerCallback& callback);

}  // namespace limber
