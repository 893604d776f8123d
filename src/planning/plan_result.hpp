#pragma once

#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "plan_ladder.hpp"
#include "planner_budget.hpp"
#include "pressure_tree.hpp"

namespace limber {

/// Whether the problem is refused before any search; status and reason then say why.
[[nodiscard]] bool is_refused(const PlanningProblem& problem, const CollisionChecker& checker,
                              PlanResult& result);

/// How a search that has ended went.
struct SearchEnd {
  PlanLadder& ladder;
  std::uint64_t queries;               ///< of the model, until now
  std::vector<Pressures> nearest_kpa;  ///< waypoints of the motion that came nearest to the goal
};

/// Finishes a search: the plan that holds, or else the motion that came nearest, simulated again
/// from the start, with the reason why the search ended and the problem's warnings. The warnings
/// come last so that they do not delay the first plan.
/// @param result  its statistics of iterations and nodes are filled in
void finish_search(const PlanningProblem& problem, MotionSimulator& simulator,
                   const PlannerBudget& budget, const SearchEnd& end, const char* planner,
                   std::uint64_t seed, PlanResult& result);

/// Of the oldest nodes, at most PlanResult::kMaxTreeEdges.
std::vector<TreeEdge> tree_edges(const PressureTree& tree);

/// Completes a result: its tree for pictures (the oldest edges), its time and its log.
/// @param end     how the search went; gives the result's time and queries
/// @param result  its statistics of queries are filled in
void close_search(const PlannerBudget& budget, const PressureTree& tree, PlannerProgress end,
                  PlanResult& result);

}  // namespace limber
