#include "pressure_rrt_star.hpp"

#include "plan_ladder.hpp"
#include "planner_name.hpp"
#include "rrt_star_search.hpp"

namespace limber {

namespace {

/// One run.
class RrtStarRun {
 public:
  RrtStarRun(const PlanningProblem& problem, const CollisionChecker& checker, const char* planner,
             std::uint64_t seed, PlannerBudget& budget)
      : budget_(budget),
        simulator_(problem.arm, problem.model, checker),
        search_(problem, simulator_, PressureRrtStarSettings(), seed),
        ladder_(problem, simulator_, budget, planner, seed) {}

  PlanResult run() {
    std::optional<double> offered_kpa = offer_cheaper(std::nullopt);
    while (!turns_.is_idle() && !budget_.good_enough(ladder_.best_cost_kpa()) &&
           !budget_.spent(progress(), search_.bytes())) {
      const std::uint64_t before = simulator_.queries();
      search_.iterate(budget_);
      turns_.note_turn(before, simulator_.queries());
      offered_kpa = offer_cheaper(offered_kpa);
    }
    return result();
  }

 private:
  PlannerProgress progress() const {
    const PlannerStatistics statistics = search_.statistics();
    return {budget_.elapsed_s(),     statistics.iterations,
            statistics.nodes,        simulator_.queries(),
            ladder_.best_cost_kpa(), [this] { return tree_edges(search_.tree()); }};
  }

  /// Where the search has a cheaper plan than `offered_kpa`, the cost of the last. One that is
  /// refused stays the search's own best: the paper's rule knows no judge.
  /// @return the cost of the last plan offered now
  std::optional<double> offer_cheaper(const std::optional<double>& offered_kpa) {
    const std::optional<double> cost_kpa = search_.best_cost_kpa();
    if (!cost_kpa || (offered_kpa && *cost_kpa >= *offered_kpa)) {
      return offered_kpa;
    }
    (void)ladder_.offer(search_.best_waypoints_kpa(), *cost_kpa, simulator_.queries());
    return cost_kpa;
  }

  PlanResult result() {
    PlanResult result;
    result.statistics = search_.statistics();
    const PlannerProgress end = progress();
    ladder_.finish(simulator_.queries(), search_.nearest_waypoints_kpa(), result);
    result.statistics.queries = simulator_.queries();
    close_search(budget_, search_.tree(), end, result);
    return result;
  }

  PlannerBudget& budget_;
  MotionSimulator simulator_;
  RrtStarSearch search_;
  PlanLadder ladder_;
  TurnTaking turns_;  // each iteration is one: those whose sample falls on a node ask no query
};

class PressureRrtStar final : public Planner {
 public:
  explicit PressureRrtStar(std::string name) : name_(std::move(name)) {}

  const char* name() const override { return name_.c_str(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    PlannerBudget budget(limits, callback);
    const CollisionChecker checker = checker_of(problem);
    PlanResult refused;
    if (is_refused(problem, checker, refused)) {
      return refused;
    }
    return RrtStarRun(problem, checker, name(), seed, budget).run();
  }

 private:
  std::string name_;
};

}  // namespace

std::unique_ptr<Planner> make_pressure_rrt_star(std::string name) {
  return std::make_unique<PressureRrtStar>(std::move(name));
}

}  // namespace limber
