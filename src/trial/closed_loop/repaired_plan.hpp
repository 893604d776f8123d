#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checked_plans.hpp"
#include "sampled_motions.hpp"

namespace limber {

/// A checked plan from the problem's start along these waypoints, their end shifted so that the tip
/// comes to rest as near to the problem's goal as it can (PlanRepair).
/// @param max_error_m  none if it ends no nearer (as_length_m)
std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check);

/// What a sampled plan has to be like.
struct SampledPlanAsked {
  double max_error_m;          ///< as_length_m
  double least_effort;         ///< SampledMotion::effort
  double better_effort = 0.0;  ///< one of so much is preferred; 0: none is
};

/// The first of these motions that is like that, as a checked plan.
/// @param motions  `sampled_motions` of the problem; its margin does not matter to them
std::optional<Plan> sampled_plan(const PlanningProblem& problem,
                                 const std::vector<SampledMotion>& motions,
                                 const SampledPlanAsked& asked, std::uint64_t seed,
                                 const PlanCheck& check);

}  // namespace limber
