#include "repaired_plan.hpp"

#include <algorithm>

#include "plan_repair.hpp"
#include "sampled_motions.hpp"

namespace limber {

namespace {

constexpr int kTries = 300;  // of the best sampled motions

}  // namespace

std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const std::optional<std::vector<Pressures>> shifted_kpa =
      PlanRepair(plans).toward_goal(waypoints_kpa, max_error_m);
  return shifted_kpa ? plans.checked(*shifted_kpa, seed) : std::nullopt;
}

std::optional<Plan> sampled_plan(const PlanningProblem& problem, const SampledPlanAsked& asked,
                                 std::uint64_t queries, std::uint64_t seed,
                                 const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const std::vector<SampledMotion> motions = sampled_motions(problem, queries, seed);
  for (const double least_effort :
       {std::max(asked.better_effort, asked.least_effort), asked.least_effort}) {
    int tried = 0;
    for (const SampledMotion& motion : motions) {
      if (motion.error_m > asked.max_error_m || motion.effort < least_effort) {
        continue;
      }
      if (++tried > kTries) {
        break;
      }
      if (!plans.end_of(motion.waypoints_kpa)) {
        continue;
      }
      if (std::optional<Plan> plan = plans.checked(motion.waypoints_kpa, seed)) {
        return plan;
      }
    }
  }
  return std::nullopt;
}

}  // namespace limber
