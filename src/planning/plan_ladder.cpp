#include "plan_ladder.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/problem_check.hpp"
#include "plan_judge.hpp"

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
  const std::string spent = budget.reason();
  std::string text = fmt::format(
      "{}, {} nodes, seed {}; the nearest motion ends "
      "{:.1f} cm from the goal (tolerance {:.1f} cm)",
      spent.empty() ? "nothing left to try" : spent, result.statistics.nodes, plan.seed,
      plan.goal_distance_m * kCmPerM, goal.position_tolerance_m * kCmPerM);
  if (goal.theta_rad) {
    text += fmt::format(" and {:.2f} rad (tolerance {:.2f} rad)", plan.goal_orientation_rad,
                        goal.orientation_tolerance_rad);
  }
  return text;
}

constexpr double kNotable = 0.95;  // of the cost judged last: worth a certificate while searching
constexpr double kWorthWaiting = 0.998;  // of the cost before: worth a rung of its own

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

std::vector<TreeEdge> tree_edges(const PressureTree& tree) {
  std::vector<TreeEdge> edges;
  const int count = std::min(tree.size(), int(PlanResult::kMaxTreeEdges) + 1);
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
  // Those that were cheaper, and did not hold. With an aim the first plan, too, may be cheaper than
  // the last.
  const double min_kpa = result.first_solution
                             ? std::min(result.plan->cost_kpa, result.first_solution->cost_kpa)
                             : result.plan->cost_kpa;
  std::erase_if(result.events, [&](const PlannerProgress& event) {
    return *event.best_cost_kpa < min_kpa - kRoundingKpa;
  });
  end.time_s = result.statistics.time_s;
  end.queries = result.statistics.queries;
  end.best_cost_kpa = result.plan->cost_kpa;
  end.tree = {};  // of a search that is over
  result.events.push_back(end);
}

PlanLadder::PlanLadder(const PlanningProblem& problem, MotionSimulator& simulator,
                       PlannerBudget& budget, std::string planner, std::uint64_t seed)
    : problem_(problem),
      simulator_(simulator),
      budget_(budget),
      planner_(std::move(planner)),
      seed_(seed) {}

const PlanLadder::Rung* PlanLadder::best() const {
  return !waiting_.empty() ? &waiting_.back() : standing_ ? &*standing_ : nullptr;
}

std::optional<double> PlanLadder::best_cost_kpa() const {
  return best() ? std::optional(best()->cost_kpa) : std::nullopt;
}

std::optional<double> PlanLadder::best_merit_kpa() const {
  return best() ? std::optional(best()->merit_kpa) : std::nullopt;
}

bool PlanLadder::offer(const std::vector<Pressures>& waypoints_kpa, double merit_kpa,
                       std::uint64_t queries) {
  const Found found{budget_.elapsed_s(), queries};
  Rung rung{waypoints_kpa, path_cost_kpa(waypoints_kpa), merit_kpa};
  // A plan cheap enough to end the search must hold.
  const bool is_judged_at_once = !standing_ || rung.merit_kpa < kNotable * standing_->merit_kpa ||
                                 budget_.good_enough(rung.cost_kpa);
  if (!is_judged_at_once) {
    // A little better than the one before it: replaces that one, so that they stay few.
    if (waiting_.size() > 1 && rung.merit_kpa > kWorthWaiting * waiting_.end()[-2].merit_kpa) {
      waiting_.pop_back();
    }
    waiting_.push_back(std::move(rung));
    return true;
  }
  const PlanJudge::Verdict verdict = judge(rung, found);
  if (verdict == PlanJudge::Verdict::unfinished) {
    waiting_.push_back(std::move(rung));
  }
  return verdict != PlanJudge::Verdict::refused;
}

PlanJudge::Verdict PlanLadder::judge(const Rung& rung, const Found& found) {
  const double begin_s = budget_.elapsed_s();
  const auto give_up = [this] { return budget_.is_overdue(); };
  PlanJudge* const judge = problem_.judge;
  Plan plan;
  PlanJudge::Verdict verdict = PlanJudge::Verdict::holds;
  try {
    // If time runs out during the measurement, the judge will say so.
    plan = build_plan(problem_, simulator_, rung.waypoints_kpa, planner_, seed_,
                      judge != nullptr ? give_up : std::function<bool()>());
    verdict = judge == nullptr ? verdict : judge->judge(plan, give_up);
  } catch (const Interrupted&) {
    verdict = PlanJudge::Verdict::unfinished;  // what stands already is kept
  }
  const double end_s = budget_.elapsed_s();
  budget_.keep_for_the_end(end_s - begin_s);
  switch (verdict) {
    case PlanJudge::Verdict::holds:
      if (!first_) {
        first_ = {end_s, rung.cost_kpa, found.queries, found.time_s, end_s - begin_s};
      }
      standing_ = rung;
      plan_ = std::move(plan);
      waiting_.clear();
      break;
    case PlanJudge::Verdict::refused:
      if (!refused_ || plan.cost_kpa < refused_->cost_kpa) {
        refused_ = std::move(plan);
      }
      break;
    case PlanJudge::Verdict::unfinished:
      unfinished_ = true;
      break;
  }
  return verdict;
}

bool PlanLadder::settle(PlanResult& result, std::uint64_t queries) {
  unfinished_ = false;
  std::vector<Rung> waiting = std::move(waiting_);
  waiting_.clear();
  while (!waiting.empty() && !unfinished_) {
    const Rung rung = std::move(waiting.back());
    waiting.pop_back();
    if (judge(rung, {budget_.elapsed_s(), queries}) == PlanJudge::Verdict::holds) {
      break;
    }
  }
  result.first_solution = first_;
  result.plan = std::move(plan_);
  if (result.plan) {
    result.status = PlanStatus::solved;
  } else if (unfinished_) {
    result.status = PlanStatus::limit;
    result.reason = "a plan was found, but its certificate was not finished in time";
  } else if (refused_) {
    result.status = PlanStatus::not_certified;
    result.best_partial = std::move(refused_);
  }
  return result.plan || unfinished_ || result.best_partial;
}

void PlanLadder::finish(std::uint64_t queries, const std::vector<Pressures>& nearest_kpa,
                        PlanResult& result) {
  result.limit = budget_.limit();
  result.status = PlanStatus::limit;
  if (!settle(result, queries)) {
    Plan plan = build_partial_plan(problem_, simulator_, nearest_kpa, planner_, seed_);
    result.reason = reason_of_failure(budget_, problem_.environment.goal, plan, result);
    result.best_partial = std::move(plan);
  } else if (result.plan) {
    result.reason = reason_of_solution(budget_);
  }
  result.warnings = find_warnings(problem_, seed_);
}

}  // namespace limber
