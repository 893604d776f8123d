#include "limber/planning/pressure_rrt_star.hpp"

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
      ParentRule rule, const PressureRrtStarSettings& settings, std::uint64_t seed)
      : problem_(problem),
        budget_(limits, callback),
        checker_(problem.arm, problem.environment.obstacles, problem.margin_m),
        simulator_(problem.arm, problem.model, checker_),
        search_(problem, simulator_, rule, settings, seed),
        seed_(seed) {}

  PlanResult run(const char* planner) {
    if (is_refused(problem_, checker_, result_)) {
      return std::move(result_);
    }
    note_first_solution();
    while (!budget_.good_enough(search_.best_cost_kpa()) &&
           !budget_.spent(progress(), search_.bytes())) {
      search_.iterate(budget_);
      note_first_solution();
    }
    finish(planner);
    return std::move(result_);
  }

 private:
  PlannerProgress progress() const {
    PlannerStatistics statistics;
    search_.fill(statistics);
    return {budget_.elapsed_s(), statistics.iterations, statistics.nodes, simulator_.queries(),
            search_.best_cost_kpa()};
  }

  void note_first_solution() {
    if (!result_.first_solution && search_.best_cost_kpa()) {
      result_.first_solution =
          FirstSolution{budget_.elapsed_s(), *search_.best_cost_kpa(), simulator_.queries()};
    }
  }

  void finish(const char* planner) {
    search_.fill(result_.statistics);
    const bool solved = search_.best_cost_kpa().has_value();
    finish_search(problem_, simulator_, budget_,
                  solved ? search_.best_waypoints_kpa() : search_.nearest_waypoints_kpa(), solved,
                  planner, seed_, result_);
    result_.statistics.queries = simulator_.queries();
    close_search(budget_, search_.tree(), progress(), result_);
  }

  const PlanningProblem& problem_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
  RrtStarSearch search_;
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
    return Run(problem, limits, callback, rule_, settings_, seed).run(name());
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
