#include "plan_result.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/units.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/problem_check.hpp"

namespace limber {

namespace {

constexpr double kRoundingKpa = 1e-3;  // between two sums of the same plan's steps

std::string reason_of_solution(const PlannerBudget& budget) {
  return budget.limit() || budget.was_stopped()
             ? budget.reason()
             : "improving the plan has ended, or it is as cheap as was asked for";
}

std::string reason_of_failure(const PlannerBudget& budget, const PoseGoal& goal, const Plan& plan,
                              const PlanResult& result) {
  std::string text = fmt::format(
      "{}, {} nodes, seed {}; the nearest motion ends "
      "{:.1f} cm from the goal (tolerance {:.1f} cm)",
      budget.reason(), result.statistics.nodes, plan.seed, plan.goal_distance_m * kCmPerM,
      goal.position_tolerance_m * kCmPerM);
  if (goal.theta_rad) {
    text += fmt::format(" and {:.2f} rad (tolerance {:.2f} rad)", plan.goal_orientation_rad,
                        goal.orientation_tolerance_rad);
  }
  return text;
}

}  // namespace

bool is_refused(const PlanningProblem& problem, const CollisionChecker& checker,
                PlanResult& result) {
  ProblemCheck check = find_refusal(problem, checker);
  if (check.refusal) {
    result.status = *check.refusal;
    result.reason = std::move(check.reason);
  }
  return check.refusal.has_value();
}

void finish_search(const PlanningProblem& problem, MotionSimulator& simulator,
                   const PlannerBudget& budget, const SearchEnd& end, const char* planner,
                   std::uint64_t seed, PlanResult& result) {
  result.limit = budget.limit();
  result.status = PlanStatus::limit;
  if (!end.ladder.settle(result, end.queries)) {
    Plan plan = build_partial_plan(problem, simulator, end.nearest_kpa, planner, seed);
    result.reason = reason_of_failure(budget, problem.environment.goal, plan, result);
    result.best_partial = std::move(plan);
  } else if (result.plan) {
    result.reason = reason_of_solution(budget);
  }
  result.warnings = find_warnings(problem, seed);
}

std::vector<TreeEdge> tree_edges(const PressureTree& tree) {
  std::vector<TreeEdge> edges;
  const int count = std::min(tree.size(), static_cast<int>(PlanResult::kMaxTreeEdges) + 1);
  for (int i = 1; i < count; ++i) {
    const auto from = tree.backbone(tree.parent(i)).bottomRows<1>();
    const auto to = tree.backbone(i).bottomRows<1>();
    edges.push_back({{from[0], from[1]}, {to[0], to[1]}});
  }
  return edges;
}

void close_search(const PlannerBudget& budget, const PressureTree& tree, PlannerProgress end,
                  PlanResult& result) {
  result.tree = tree_edges(tree);
  result.statistics.time_s = budget.elapsed_s();
  if (!result.plan) {
    return;
  }
  result.events = budget.events();
  // Those that were cheaper, and did not hold.
  std::erase_if(result.events, [&](const PlannerProgress& event) {
    return *event.best_cost_kpa < result.plan->cost_kpa - kRoundingKpa;
  });
  end.time_s = result.statistics.time_s;
  end.queries = result.statistics.queries;
  end.best_cost_kpa = result.plan->cost_kpa;
  result.events.push_back(end);
}

}  // namespace limber
