#include "limber/planning/pressure_rrt_star.hpp"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/planning/plan_builder.hpp"
#include "plan_improver.hpp"
#include "rrt_star_search.hpp"

namespace limber {

namespace {

void require_between(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw InputError(
        fmt::format("planner setting {} = {}; expected {} to {}", name, value, low, high));
  }
}

void require_valid(const PressureRrtStarSettings& s) {
  require_between("step_size", s.step_size, 1e-3, 10.0);
  require_between("near_factor", s.near_factor, 1.0, 100.0);
  require_between("goal_bias", s.goal_bias, 0.0, 1.0);
  require_between("goal_shots", s.goal_shots, 0.0, 1.0);
  require_between("goal_bias + goal_shots", s.goal_bias + s.goal_shots, 0.0, 1.0);
  require_between("goal_spread", s.goal_spread, 0.0, 10.0);
  require_between("goal_configurations", s.goal_configurations, 1, 1e6);
  require_between("match_position_m", s.match_position_m, 0.0, 1.0);
  require_between("match_orientation_rad", s.match_orientation_rad, 0.0, 10.0);
  require_between("hold_position_m", s.hold_position_m, 0.0, 10.0);
  require_between("hold_orientation_rad", s.hold_orientation_rad, 0.0, 10.0);
}

/// One run: the tree, and where wanted the improvement of the best plan it has found.
class Run {
 public:
  Run(const PlanningProblem& problem, const PlannerLimits& limits, const PlannerCallback& callback,
      ParentRule rule, const PressureRrtStarSettings& settings, int improvements,
      std::uint64_t seed)
      : problem_(problem),
        budget_(limits, callback),
        checker_(problem.arm, problem.environment.obstacles, problem.margin_m),
        simulator_(problem.arm, problem.model, checker_),
        search_(problem, simulator_, rule, settings, seed),
        improver_(problem, simulator_, seed),
        improvements_(improvements),
        seed_(seed) {}

  PlanResult run(const char* planner) {
    ProblemCheck check = check_problem(problem_, checker_, seed_);
    result_.warnings = std::move(check.warnings);
    if (check.refusal) {
      result_.status = *check.refusal;
      result_.reason = std::move(check.reason);
      return std::move(result_);
    }
    note_solution();
    while (!budget_.good_enough(best_cost_kpa_) && !budget_.spent(progress(), search_.bytes())) {
      search_.iterate(budget_);
      note_solution();
      improve();
    }
    finish(planner);
    return std::move(result_);
  }

 private:
  PlannerProgress progress() const {
    PlannerStatistics statistics;
    search_.fill(statistics);
    return {budget_.elapsed_s(), statistics.iterations, statistics.nodes, simulator_.queries(),
            best_cost_kpa_};
  }

  /// Takes over what the tree has found.
  void note_solution() {
    const std::optional<double> found = search_.best_cost_kpa();
    if (!found || (best_cost_kpa_ && *found >= *best_cost_kpa_)) {
      return;
    }
    if (!best_cost_kpa_) {
      result_.first_solution = FirstSolution{budget_.elapsed_s(), *found};
    }
    best_cost_kpa_ = found;
    best_waypoints_kpa_ = search_.best_waypoints_kpa();
    if (improvements_ > 0) {
      improver_.adopt(best_waypoints_kpa_);
    }
  }

  void improve() {
    for (int k = 0; k < improvements_ && improver_.has_plan() && !budget_.out_of_time(); ++k) {
      if (improver_.try_once()) {
        best_cost_kpa_ = improver_.cost_kpa();
        best_waypoints_kpa_ = improver_.waypoints_kpa();
      }
    }
  }

  void finish(const char* planner) {
    search_.fill(result_.statistics);
    result_.limit = budget_.limit();
    result_.status = best_cost_kpa_ ? PlanStatus::solved : PlanStatus::limit;
    const std::vector<Pressures> waypoints =
        best_cost_kpa_ ? best_waypoints_kpa_ : search_.nearest_waypoints_kpa();
    Plan plan = build_plan(problem_, simulator_, waypoints, planner, seed_);
    assert(!best_cost_kpa_ || is_solution(problem_, checker_, plan));
    result_.reason = reason(plan);
    (best_cost_kpa_ ? result_.plan : result_.best_partial) = std::move(plan);
    result_.statistics.queries = simulator_.queries();
    collect_tree();
    result_.statistics.time_s = budget_.elapsed_s();
  }

  std::string reason(const Plan& plan) const {
    if (best_cost_kpa_) {
      return budget_.limit() || budget_.stopped_by_callback()
                 ? budget_.reason()
                 : "the plan is as cheap as was asked for";
    }
    const PoseGoal& goal = problem_.environment.goal;
    std::string text = fmt::format(
        "{}, {} nodes, seed {}; the nearest motion ends {:.1f} cm from the goal (tolerance {:.1f} "
        "cm)",
        budget_.reason(), result_.statistics.nodes, seed_, plan.goal_distance_m * kCmPerM,
        goal.position_tolerance_m * kCmPerM);
    if (goal.theta_rad) {
      text += fmt::format(" and {:.2f} rad (tolerance {:.2f} rad)", plan.goal_orientation_rad,
                          goal.orientation_tolerance_rad);
    }
    return text;
  }

  void collect_tree() {
    const PressureTree& tree = search_.tree();
    const int count = std::min(tree.size(), static_cast<int>(PlanResult::kMostTreeEdges) + 1);
    for (int i = 1; i < count; ++i) {
      const auto from = tree.backbone(tree.parent(i)).bottomRows<1>();
      const auto to = tree.backbone(i).bottomRows<1>();
      result_.tree.push_back({{from[0], from[1]}, {to[0], to[1]}});
    }
  }

  const PlanningProblem& problem_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
  RrtStarSearch search_;
  PlanImprover improver_;
  int improvements_;
  std::uint64_t seed_;
  std::optional<double> best_cost_kpa_;
  std::vector<Pressures> best_waypoints_kpa_;
  PlanResult result_;
};

class PressureRrtStar final : public Planner {
 public:
  PressureRrtStar(const char* name, ParentRule rule, const PressureRrtStarSettings& settings,
                  int improvements)
      : name_(name), rule_(rule), settings_(settings), improvements_(improvements) {
    require_valid(settings);
  }

  const char* name() const override { return name_; }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    return Run(problem, limits, callback, rule_, settings_, improvements_, seed).run(name_);
  }

 private:
  const char* name_;
  ParentRule rule_;
  PressureRrtStarSettings settings_;
  int improvements_;
};

}  // namespace

std::unique_ptr<Planner> make_pressure_rrt_star(ParentRule rule,
                                                const PressureRrtStarSettings& settings) {
  return std::make_unique<PressureRrtStar>(rule == ParentRule::lazy ? "paper" : "paper-steer-all",
                                           rule, settings, 0);
}

PressureRrtStarSettings default_planner_settings() {
  PressureRrtStarSettings settings;
  settings.goal_bias = 0.1;
  settings.goal_shots = 0.1;
  settings.rewire = false;
  return settings;
}

std::unique_ptr<Planner> make_improving_planner(const PressureRrtStarSettings& settings,
                                                int improvements_per_iteration) {
  require_between("improvements_per_iteration", improvements_per_iteration, 1, 1e6);
  return std::make_unique<PressureRrtStar>("default", ParentRule::lazy, settings,
                                           improvements_per_iteration);
}

}  // namespace limber
