#include "pressure_rrt_star.hpp"

#include "plan_result.hpp"
#include "rrt_star_search.hpp"
#include "setting_check.hpp"

namespace limber {

namespace {

void require_valid(const PressureRrtStarSettings& s) {
  require_between("step_size", s.step_size, 1e-3, 10.0);
  require_between("near_factor", s.near_factor, 1.0, 100.0);
  require_between("goal_bias", s.goal_bias, 0.0, 1.0);
  require_between("goal_spread", s.goal_spread, 0.0, 10.0);
  require_between("goal_configurations", s.goal_configurations, 1, 1e6);
  require_between("match_pressure_kpa", s.match_pressure_kpa, 0.0, 1e6);
  require_between("match_position_m", s.match_position_m, 0.0, 1.0);
  require_between("match_orientation_rad", s.match_orientation_rad, 0.0, 10.0);
  require_between("hold_position_m", s.hold_position_m, 0.0, 10.0);
  require_between("hold_orientation_rad", s.hold_orientation_rad, 0.0, 10.0);
}

/// One run.
class Run {
 public:
  Run(const PlanningProblem& problem, const PlannerLimits& limits, const PlannerCallback& callback,
      ParentRule rule, const PressureRrtStarSettings& settings, const char* planner,
      std::uint64_t seed)
      : problem_(problem),
        budget_(limits, callback),
        checker_(problem.arm, problem.environment.obstacles, problem.margin_m),
        simulator_(problem.arm, problem.model, checker_),
        search_(problem, simulator_, rule, settings, seed),
        ladder_(problem, simulator_, budget_, planner, seed),
        planner_(planner),
        seed_(seed) {}

  PlanResult run() {
    if (is_refused(problem_, checker_, result_)) {
      return std::move(result_);
    }
    note_plan();
    while (!budget_.good_enough(ladder_.best_cost_kpa()) &&
           !budget_.spent(progress(), search_.bytes())) {
      search_.iterate(budget_);
      note_plan();
    }
    finish();
    return std::move(result_);
  }

 private:
  PlannerProgress progress() const {
    PlannerStatistics statistics;
    search_.fill(statistics);
    return {budget_.elapsed_s(), statistics.iterations, statistics.nodes, simulator_.queries(),
            ladder_.best_cost_kpa()};
  }

  /// Where the search has a cheaper one. One that is refused stays the search's own best: the
  /// paper's rule knows no judge.
  void note_plan() {
    const std::optional<double> cost_kpa = search_.best_cost_kpa();
    if (cost_kpa && (!offered_kpa_ || *cost_kpa < *offered_kpa_)) {
      offered_kpa_ = cost_kpa;
      (void)ladder_.offer(search_.best_waypoints_kpa(), *cost_kpa, simulator_.queries());
    }
  }

  void finish() {
    search_.fill(result_.statistics);
    const PlannerProgress end = progress();
    finish_search(problem_, simulator_, budget_,
                  {ladder_, simulator_.queries(), search_.nearest_waypoints_kpa()}, planner_, seed_,
                  result_);
    result_.statistics.queries = simulator_.queries();
    close_search(budget_, search_.tree(), end, result_);
  }

  const PlanningProblem& problem_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
  RrtStarSearch search_;
  PlanLadder ladder_;
  std::optional<double> offered_kpa_;
  const char* planner_;
  std::uint64_t seed_;
  PlanResult result_;
};

class PressureRrtStar final : public Planner {
 public:
  PressureRrtStar(std::string name, ParentRule rule, const PressureRrtStarSettings& settings)
      : name_(std::move(name)), rule_(rule), settings_(settings) {
    require_valid(settings);
  }

  const char* name() const override { return name_.c_str(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    return Run(problem, limits, callback, rule_, settings_, name(), seed).run();
  }

 private:
  std::string name_;
  ParentRule rule_;
  PressureRrtStarSettings settings_;
};

}  // namespace

std::unique_ptr<Planner> make_pressure_rrt_star(ParentRule rule,
                                                const PressureRrtStarSettings& settings,
                                                std::string name) {
  if (name.empty()) {
    name = rule == ParentRule::lazy ? "paper" : "paper-steer-all";
  }
  return std::make_unique<PressureRrtStar>(std::move(name), rule, settings);
}

}  // namespace limber
