#include "certified_planner.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "asked_problem.hpp"
#include "certifying_judge.hpp"
#include "given_waypoints.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/problem_check.hpp"
#include "plan_ladder.hpp"
#include "search/default_planner.hpp"

namespace limber {

namespace {

/// Of the limits, for the search with the clearance that was asked for, where it finds nothing; the
/// rest is for smaller ones. But never more time than that.
constexpr double kPatience = 0.9;
constexpr double kMaxForSmallerS = 1.0;

constexpr double kMinSearchS = 1e-3;  // a time limit is positive

bool is_refusal(PlanStatus status) {
  return status == PlanStatus::invalid_start || status == PlanStatus::goal_unreachable ||
         status == PlanStatus::goal_in_collision;
}

/// Searches name the tolerance that they were given.
std::string kept_of_tolerance(const PlanningProblem& problem) {
  if (problem.goal_margin.position_m <= 0.0) {
    return "";
  }
  const double searched_m =
      with_room(problem.environment, problem.goal_margin).goal.position_tolerance_m;
  return fmt::format(
      "; {:.2f} cm of the tolerance are kept for the model's error: --goal-margin-m 0 keeps none",
      (problem.environment.goal.position_tolerance_m - searched_m) * kCmPerM);
}

class CertifiedPlanner final : public Planner {
 public:
  CertifiedPlanner(std::unique_ptr<Planner> planner, int jobs, Valves valves)
      : planner_(std::move(planner)), jobs_(jobs), valves_(valves) {}

  const char* name() const override { return planner_->name(); }

  PlanResult plan(const PlanningProblem& asked, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    require_planar(asked.arm, "a planner");
    require_model_of_arm(asked.arm, asked.model, "a planner");
    require_margin(asked.margin_m);  // before it is raised to what a certificate asks for
    require_goal_margin(asked.goal_margin);
    const SteadyTime start = std::chrono::steady_clock::now();
    PlanningProblem problem = asked;
    if (valves_ == Valves::left_out) {
      problem.model = asked.model.without_valves();
    }
    std::vector<std::string> notes = warnings_of_aim(problem);
    yield_to_start(problem, notes);
    AskedProblem shared(problem);
    const bool may_keep_less = problem.margin_m > 0.0 || problem.tube;
    PlannerLimits whole = limits;
    if (may_keep_less) {
      whole.patience =
          limits.time_s ? std::max(kPatience, 1.0 - kMaxForSmallerS / *limits.time_s) : kPatience;
    }
    bool stopped = false;  // then nobody waits for explanations
    const PlannerCallback watched = [&](const PlannerProgress& now) {
      stopped = stopped || (callback && !callback(now));
      return !stopped;
    };
    PlannerLimits patient = whole;
    if (limits.time_s && *limits.time_s > 0.0) {  // else it is refused as it is
      patient.time_s = std::max(kMinSearchS, *limits.time_s - seconds_since(start));
    }
    PlanResult result = certified_search(*planner_, problem, shared, patient, seed, watched);
    result.warnings.insert(result.warnings.begin(), notes.begin(), notes.end());
    if (!result.plan && !stopped && !interrupt_requested()) {
      explain(
          problem, seed, [&] { return limits.time_s && seconds_since(start) > *limits.time_s; },
          result);
      if (may_keep_less && result.status != PlanStatus::not_certified) {
        const std::unique_ptr<Planner> for_smaller = make_default_planner({.jobs = jobs_});
        try_smaller_clearances(*for_smaller, problem, shared, whole, start, seed, watched, result);
      }
    }
    result.statistics.time_s = seconds_since(start);
    return result;
  }

 private:
  /// A refusal's amounts are those of the problem as it was asked, wherever it is refused as such;
  /// a search that found nothing says so if there may have been nothing to find.
  static void explain(const PlanningProblem& problem, std::uint64_t seed,
                      const std::function<bool()>& is_late, PlanResult& result) {
    const CollisionChecker checker = checker_of(problem);
    if (result.status == PlanStatus::limit) {
      const std::string note = reached_only_in_collision(problem, checker, seed, is_late);
      result.reason += (result.best_partial ? kept_of_tolerance(problem) : "") +
                       (note.empty() ? "" : "; " + note);
      return;
    }
    if (!is_refusal(result.status)) {
      return;
    }
    if (!is_refused(problem, checker, result) && result.status != PlanStatus::invalid_start) {
      result.reason += kept_of_tolerance(problem);
    }
  }

  std::unique_ptr<Planner> planner_;
  int jobs_;
  Valves valves_;
};

}  // namespace

std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner, int jobs,
                                                Valves valves) {
  return std::make_unique<CertifiedPlanner>(std::move(planner), jobs, valves);
}

}  // namespace limber
