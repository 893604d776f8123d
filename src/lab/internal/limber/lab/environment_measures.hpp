#pragma once

#include <optional>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Whether the straight motion in pressure from the start to `to_kpa`, the hold included, collides
/// as the problem's model predicts it.
bool straight_line_collides(const PlanningProblem& problem, const Pressures& to_kpa);

/// Whether some straight motion in pressure solves the problem: to `to_kpa` where given, or to a
/// configuration whose no-load tip is at the goal (from `starts` random starts of `seed`).
bool straight_line_solves(const PlanningProblem& problem, const std::vector<Pressures>& to_kpa,
                          int starts, std::uint64_t seed);

/// A point at which the arm has obstacles on both sides.
struct Passage {
  double width_m = 0.0;      ///< from obstacle to obstacle, across the arm
  double arm_width_m = 0.0;  ///< there: the segment's width + twice the actuator radius
  int frame = 0;
  int plate = 0;  ///< from 0, the base
};

/// The passage of a motion that is narrowest relative to the arm's width. At each plate of each
/// frame, obstacles are looked for along the normal on both sides, up to the arm's length away.
/// None if no plate ever has obstacles on both sides.
std::optional<Passage> narrowest_passage(const ArmDescription& arm, const Environment& environment,
                                         const std::vector<PlanFrame>& frames);

/// How much of a motion's cost comes from reversals: Σ|Δp| over the frames, less that of the
/// straight motion. 0 if every pressure only rises or only falls.
double reversal_kpa(const std::vector<PlanFrame>& frames);

}  // namespace limber
