#include "repaired_plan.hpp"

#include "plan_repair.hpp"

namespace limber {

std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const std::optional<std::vector<Pressures>> shifted_kpa =
      PlanRepair(plans).toward_goal(waypoints_kpa, max_error_m);
  return shifted_kpa ? plans.checked(*shifted_kpa, "repair", seed) : std::nullopt;
}

}  // namespace limber
