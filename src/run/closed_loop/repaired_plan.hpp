#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checked_plans.hpp"

namespace limber {

/// A checked plan from the problem's start along these waypoints, their end shifted so that the tip
/// comes to rest as near to the problem's goal as it can (PlanRepair).
/// @param max_error_m  none if it ends no nearer (as_length_m)
std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check);

}  // namespace limber
