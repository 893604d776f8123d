#include "sampled_plan.hpp"

#include <algorithm>

#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

constexpr int kTries = 300;  // of the best sampled motions

}  // namespace

std::optional<Plan> sampled_plan(const PlanningProblem& problem,
                                 const std::vector<SampledMotion>& motions,
                                 const SampledPlanAsked& asked, std::uint64_t seed,
                                 const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const double better_effort = std::max(asked.better_effort, asked.least_effort);
  for (const bool is_preferred : {true, false}) {
    int tried = 0;
    for (const SampledMotion& motion : motions) {
      if (!(motion.error_m <= asked.max_error_m && motion.effort >= asked.least_effort) ||
          (motion.effort >= better_effort) != is_preferred) {
        continue;
      }
      if (++tried > kTries || interrupt_requested()) {
        break;
      }
      if (!plans.end_of(motion.waypoints_kpa)) {
        continue;
      }
      if (std::optional<Plan> plan = plans.checked(motion.waypoints_kpa, "sampled", seed)) {
        return plan;
      }
    }
  }
  return std::nullopt;
}

}  // namespace limber
