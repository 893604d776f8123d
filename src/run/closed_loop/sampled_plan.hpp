#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checked_plans.hpp"
#include "sampled_motions.hpp"

namespace limber {

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
