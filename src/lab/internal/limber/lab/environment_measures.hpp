#pragma once

#include <cstdint>
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

}  // namespace limber
