#pragma once
// For those who plan.

#include <memory>
#include <string>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

struct Forest;

/// Names that `make_planner` knows, the default first.
std::vector<std::string> planner_names();

/// Its plans are certified (docs/planning.md, Certificate).
/// @param name    one of those; settings may follow it: "default,improved_plans=0"
/// @param jobs    threads to use if the planner uses several, 0 for one per core
/// @param forest  of the arm, model and start to plan for, for the default planner; borrowed
/// @throws InputError naming the known planners, or the one that can't use a forest.
std::unique_ptr<Planner> make_planner(const std::string& name, int jobs = 0,
                                      const Forest* forest = nullptr);

/// The motion that a planner of your own proposes: from the problem's start straight to each
/// waypoint in turn, simulated with the problem's model, held, and certified, as every planner's
/// plans are. Solved if it is. If not, the status is `not_certified`, the reason says what is
/// wrong, and the motion is `best_partial`, its clearance measured; motions that collide or end
/// outside of the goal take no certificate. An arm that starts nearer to an obstacle than the
/// margin is refused (invalid_start), unless PlanningProblem::margin_yields_to_start says that the
/// margin then yields.
/// @param waypoints_kpa  at least one, each of n set points within the problem's limits
/// @param planner        name that the plan file keeps
/// @param seed           that the plan file keeps
/// @throws InputError naming the waypoint that does not fit.
[[nodiscard]] PlanResult plan_along(const PlanningProblem& problem,
                                    const std::vector<Pressures>& waypoints_kpa,
                                    const std::string& planner, std::uint64_t seed = 0);

/// A sentence for each old name in `name`, which is still understood, with its new name.
/// @throws InputError if the settings are no key=value.
std::vector<std::string> planner_name_notes(const std::string& name);

/// Whether that is the default planner, with settings or without.
/// @throws InputError if the settings are no key=value.
bool is_default_planner(const std::string& name);

}  // namespace limber
