#pragma once

#include <cstdint>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"

namespace limber {

// What random environments consist of, drawn one after another from a stream.

/// An arm's length over that of the paper's arm, which sizes of obstacles are given for.
double size_unit(const ArmDescription& arm);

/// A circle, rectangle or simple polygon about a point, 1.5 to 25 cm large for the paper's arm.
Obstacle random_obstacle(double unit, const Eigen::Vector2d& at, RandomStream& random);

/// Where that tip is, with the tolerances of limber's own environments; it may ask for its heading.
PoseGoal random_goal(const Pose& tip, RandomStream& random);

/// Whether the straight motion in pressure from the start to `to_kpa`, the hold included, collides
/// as the problem's model predicts it.
bool straight_line_collides(const PlanningProblem& problem, const Pressures& to_kpa);

/// Whether some straight motion in pressure solves the problem: to `to_kpa` where given, or to a
/// configuration whose no-load tip is at the goal (from `starts` random starts of `seed`).
bool straight_line_solves(const PlanningProblem& problem, const std::vector<Pressures>& to_kpa,
                          int starts, std::uint64_t seed);

}  // namespace limber
