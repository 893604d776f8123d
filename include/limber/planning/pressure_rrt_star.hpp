#pragma once

#include "limber/planning/planner.hpp"

namespace limber {

/// What the paper leaves open of its planner, with our choices (docs/planning.md says why).
/// Distances in pressure are Euclidean, each pressure as a fraction of its segment's limit.
struct PressureRrtStarSettings {
  double step_size = 0.5;    ///< longest edge, > 0
  double near_factor = 1.0;  ///< × the least radius that RRT* allows, ≥ 1; at most the step size
  double goal_bias = 0.2;    ///< share of samples at inverse-kinematics solutions, in [0, 1]
  double goal_spread = 0.1;  ///< standard deviation about such a solution: it is approximate
  int goal_configurations = 200;    ///< solutions drawn before they are used again, ≥ 1
  double match_position_m = 0.005;  ///< a rewired node's backbone agrees at every plate
  double match_orientation_rad = 0.05;
  bool rewire = true;
  /// Share of samples that step from a node with its tip near the goal toward the goal, in [0, 1];
  /// the paper has none.
  double goal_shots = 0.0;
  double hold_position_m = 0.05;  ///< nodes whose tip is this near the goal are held and judged
  double hold_orientation_rad = 0.5;
};

/// The paper's planner (IV-D and IV-E): RRT* over states (q, B). A new configuration is reached
/// from the cheapest of the near nodes whose motion is free; a node is rewired only where the new
/// way ends at the same pressures and the same backbone, and everything downstream, simulated
/// anew, stays free.
enum class ParentRule {
  lazy,      ///< sorts near nodes by the cost, known beforehand, and simulates from the cheapest
  steer_all  ///< as written: simulates from all near nodes, then sorts; the same tree, slower
};

/// "paper" or "paper-steer-all". @throws InputError where a setting is out of range.
std::unique_ptr<Planner> make_pressure_rrt_star(
    ParentRule rule, const PressureRrtStarSettings& settings = PressureRrtStarSettings());

/// Settings of the default planner's tree: goal shots instead of half of the bias, no rewiring.
PressureRrtStarSettings default_planner_settings();

/// "default": a tree as the paper's until the first solution; from then on its turns alternate with
/// attempts to improve the best plan, by leaving out, straightening and shifting waypoints, each
/// accepted only after exact simulation and collision check of everything behind the change.
/// `improvements_per_iteration` > 0.
std::unique_ptr<Planner> make_improving_planner(
    const PressureRrtStarSettings& settings = default_planner_settings(),
    int improvements_per_iteration = 4);

}  // namespace limber
