#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Searches work in float32 and certificates in double, so a search gets this much less room: far
/// above the rounding of the forward model over a plan, and far below what matters to a plan.
inline constexpr double kReserveM = Certificate::kDeviationM;
inline constexpr double kReserveRad = Certificate::kHeadingDeviationRad;

/// `environment`, its goal's tolerances less what the model errs by, and a reserve.
Environment with_room(Environment environment, const PoseError& margin);

/// What a search prefers within its goal, where there is an error to keep room for.
std::optional<PoseError> aim_of(const PlanningProblem& problem);

/// Whether plans that end where they aim end in the goal also with the model's error.
bool has_room(const PlanningProblem& problem);

/// Where the goal has no room for the error: what is aimed at instead.
std::vector<std::string> warnings_of_aim(const PlanningProblem& problem);

}  // namespace limber
