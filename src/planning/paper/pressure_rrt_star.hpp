#pragma once

#include "limber/planning/planner.hpp"

namespace limber {

/// What the paper leaves open about its planner, with our choices (docs/planning.md says why).
/// Distances in pressure are Euclidean, each pressure as a fraction of its segment's limit.
struct PressureRrtStarSettings {
  double step_size = 0.5;  ///< longest edge, > 0
  double near_factor = 1.0;  ///< × the smallest radius that RRT* allows, ≥ 1; at most the step size
  double goal_bias = 0.2;         ///< share of samples at inverse-kinematics solutions, in [0, 1]
  double goal_spread = 0.1;       ///< standard deviation about such a solution: it is approximate
  int goal_configurations = 200;  ///< solutions sampled before they are used again, ≥ 1
  /// Of the largest limit: a rewired node's set points are the same, its pressures agree so,
  double match_pressure = 0.01;
  double match_position_m = 0.005;  ///< and its backbone agrees at every plate
  double match_orientation_rad = 0.05;
  double hold_position_m = 0.05;  ///< nodes whose tip is this near the goal are held and judged
  double hold_orientation_rad = 0.5;
};

/// The paper's planner (IV-D and IV-E): RRT* over states (q, B); with valves, q is set points and
/// pressures. A new configuration is reached from the cheapest of the near nodes whose motion is
/// free. A node is rewired only if the new path ends at the same pressures and the same backbone,
/// and everything downstream, simulated again, stays free. Near nodes are sorted by the cost, known
/// beforehand, and simulated from the cheapest on; as written, all are simulated and then sorted:
/// the same tree from nine times the queries.
///
/// @param name  the planner's name in plans
std::unique_ptr<Planner> make_pressure_rrt_star(std::string name = "paper");

}  // namespace limber
