#pragma once

#include "asked_problem.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// `problem`, planned in by `planner` with a little less room and certified as it was asked.
/// @param asked  the same arm, model and environment, whatever their margins
PlanResult certified_search(Planner& planner, const PlanningProblem& problem, AskedProblem& asked,
                            const PlannerLimits& limits, std::uint64_t seed,
                            const PlannerCallback& callback);

}  // namespace limber
