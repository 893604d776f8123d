#include "plan_ladder.hpp"

#include <algorithm>

#include "limber/planning/plan_builder.hpp"
#include "second_opinions.hpp"

namespace limber {

namespace {

constexpr double kNotable = 0.95;  // of the cost judged last: worth a certificate while searching
constexpr double kWorthWaiting = 0.998;  // of the cost before: worth a rung of its own

}  // namespace

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
  if (!is_notable(rung)) {
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

/// Whether it is judged at once. A plan cheap enough to end the search must hold.
bool PlanLadder::is_notable(const Rung& rung) const {
  return !standing_ || rung.merit_kpa < kNotable * standing_->merit_kpa ||
         budget_.good_enough(rung.cost_kpa);
}

PlanJudge::Verdict PlanLadder::judge(const Rung& rung, const Found& found) {
  const double begin_s = budget_.elapsed_s();
  const auto give_up = [this] { return budget_.is_overdue(); };
  PlanJudge* const judge = problem_.judge;
  // If time runs out during the measurement, the judge will say so.
  Plan plan = build_plan(problem_, simulator_, rung.waypoints_kpa, planner_, seed_,
                         judge != nullptr ? give_up : std::function<bool()>());
  const PlanJudge::Verdict verdict =
      judge == nullptr ? PlanJudge::Verdict::holds : judge->judge(plan, give_up);
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

}  // namespace limber
