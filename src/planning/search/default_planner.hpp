#pragma once

#include <memory>
#include <string>

#include "goal_seeker.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "planner_name.hpp"

namespace limber {

/// The default planner's choices; docs/planning.md says what was measured. Distances in pressure
/// are Euclidean, each pressure as a fraction of its segment's limit.
struct DefaultPlannerSettings {
  double step_size = 0.5;  ///< longest edge of an exploration, > 0
  double goal_steering_share =
      0.3;                    ///< share of edges that step from a node toward the goal, in [0, 1]
  double shot_spread = 0.02;  ///< standard deviation about such a step, ≥ 0
  double goal_bias = 0.2;     ///< share at inverse-kinematics solutions, in [0, 1]
  double goal_spread = 0.1;   ///< standard deviation about such a solution, ≥ 0
  int goal_configurations = 200;  ///< solutions sampled before they are used again, ≥ 1
  double random_parent = 0.5;     ///< share of edges from any near node instead of the nearest
  /// States in one cell of pressures, tip position and tip heading are alike: the cheapest is kept.
  double cell_pressure = 0.05;
  double cell_position_m = 0.01;
  double cell_orientation_rad = 0.1;
  double max_cost_ratio = 2.0;  ///< nodes above this × the best plan's cost are not tried, ≥ 1
  int improved_plans = 3;       ///< how many are improved side by side; 0: none
  /// Queries of the model after the first plan, then the search ends: from there on plans get
  /// cheaper by the model's errors, and executions worse (docs/planning.md).
  double improvement_queries = 200'000;
  double improvement_queries_without_room = 10'000;  ///< if the goal leaves none for the error
  /// Queries of the shortest search; without a plan it then begins again (planner_budget.hpp).
  double restart_queries = 20'000;
  double hold_position_m = HoldRange().position_m;  ///< paths that end so near are held and judged
  double hold_orientation_rad = HoldRange().orientation_rad;
  int jobs = 0;  ///< threads, 0 for one per core; the plan does not depend on it
  /// Grown for the arm, model and start of every problem, and tried first, in turns with the
  /// search; borrowed. None: everything is searched.
  const Forest* forest = nullptr;
};

/// @throws InputError naming the setting that is out of range, and its range.
void require_valid(const DefaultPlannerSettings& settings);

/// The settings behind a planner's name, the others by default.
/// @throws InputError if one is unknown or out of range.
DefaultPlannerSettings default_settings_of(PlannerName name);

/// "default": a tree that keeps several backbones for similar pressures and grows by batches of
/// edges. The plans that it finds are improved by batches of random changes of their waypoints;
/// each change is accepted only after exact simulation and collision check of everything after it.
/// The best plan is improved as far as possible, while others from the tree compete with it.
/// @param name  the planner's name in plans
/// @throws InputError if a setting is out of range.
std::unique_ptr<Planner> make_default_planner(
    const DefaultPlannerSettings& settings = DefaultPlannerSettings(),
    std::string name = "default");

}  // namespace limber
