#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "plan_judge.hpp"
#include "planner_budget.hpp"
#include "pressure_tree.hpp"

namespace limber {

/// The plans that a search has found, each better than those before it (cheaper, or ending nearer
/// to the aim), and which of them the problem's judge accepts. The first, and each that is notably
/// better than the last accepted one, is judged at once. The others wait until the search has
/// ended, and are then judged from the best down until one is accepted. So a refused plan does not
/// cost any of the others. Without a judge every plan is accepted. All arguments are borrowed.
class PlanLadder {
 public:
  PlanLadder(const PlanningProblem& problem, MotionSimulator& simulator, PlannerBudget& budget,
             std::string planner, std::uint64_t seed);

  /// A plan that is better than all that stand. @param waypoints_kpa  start first
  /// @param merit_kpa  smaller is better; the plan's cost, unless something else counts too
  /// @return whether it may be built upon: false if it was judged and refused
  bool offer(const std::vector<Pressures>& waypoints_kpa, double merit_kpa, std::uint64_t queries);

  /// Merit of the best plan that was offered and not refused; none: there is none.
  std::optional<double> best_cost_kpa() const;
  std::optional<double> best_merit_kpa() const;

  /// Ends it: `result` gets its status, the plan that holds and the first that did; where none did,
  /// the cheapest that was refused (`best_partial`), or that time ran out.
  /// @return whether there was a plan at all, of whatever standing
  bool settle(PlanResult& result, std::uint64_t queries);

  /// Finishes the search: settled, or else the motion that came nearest, simulated again from the
  /// start, with the reason why the search ended and the problem's warnings. The warnings come last
  /// so that they do not delay the first plan.
  /// @param queries      of the model, until now
  /// @param nearest_kpa  waypoints of the motion that came nearest to the goal
  /// @param result       its statistics of iterations and nodes are filled in
  void finish(std::uint64_t queries, const std::vector<Pressures>& nearest_kpa, PlanResult& result);

 private:
  struct Rung {
    std::vector<Pressures> waypoints_kpa;
    double cost_kpa;
    double merit_kpa;
  };

  struct Found {
    double time_s;
    std::uint64_t queries;
  };

  /// Builds and judges; a plan that holds becomes the one that stands.
  PlanJudge::Verdict judge(const Rung& rung, const Found& found);
  const Rung* best() const;

  const PlanningProblem& problem_;
  MotionSimulator& simulator_;
  PlannerBudget& budget_;
  std::string planner_;
  std::uint64_t seed_;

  std::optional<Rung> standing_;  // the best that holds
  std::optional<Plan> plan_;      // built from it
  std::vector<Rung> waiting_;     // better than that one, the best last
  std::optional<Plan> refused_;
  bool unfinished_ = false;
  std::optional<FirstSolution> first_;
};

/// Whether the problem is refused before any search; status and reason then say why.
[[nodiscard]] bool is_refused(const PlanningProblem& problem, const CollisionChecker& checker,
                              PlanResult& result);

/// Of the oldest nodes, at most PlanResult::kMaxTreeEdges.
std::vector<TreeEdge> tree_edges(const PressureTree& tree);

/// Completes a result: its tree for pictures (the oldest edges), its time and its log.
/// @param end     how the search went; gives the result's time and queries
/// @param result  its statistics of queries are filled in
void close_search(const PlannerBudget& budget, const PressureTree& tree, PlannerProgress end,
                  PlanResult& result);

}  // namespace limber
