#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "planner_budget.hpp"
#include "second_opinions.hpp"

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
  bool is_notable(const Rung& rung) const;
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

}  // namespace limber
