#pragma once

#include <string>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Where PlanningProblem::margin_yields_to_start says so, and the arm starts nearer to an obstacle
/// than the margin: plans keep what it starts with. A sentence about it goes to `notes`.
void yield_to_start(PlanningProblem& problem, std::vector<std::string>& notes);

}  // namespace limber
