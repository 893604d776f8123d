#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "checked_plans.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// A short motion from where an arm rests.
struct SampledMotion {
  std::vector<Pressures> waypoints_kpa;  ///< its start first, its end last
  double effort = 0.0;   ///< its cost, (2), over a pressure scale (pressure_scales_kpa, the mean)
  double error_m = 0.0;  ///< of the tip after the hold, as_length_m
};

/// Short motions from a problem's start that end near its goal, the best first: the error, and a
/// little for the effort, since the network errs more the farther an arm goes. Half of them are
/// straight, half go by way of another point. Around the best, more are sampled.
///
/// Friction holds an arm that is hardly moved, for the model too: slopes at rest say little of
/// where a step leads, and from some places no straight step leads where another one before it
/// does. Obstacles are not looked at.
/// @param queries  of the model at 20 Hz, about as many; those around the best come on top
std::vector<SampledMotion> sampled_motions(const PlanningProblem& problem, std::uint64_t queries,
                                           std::uint64_t seed);

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
