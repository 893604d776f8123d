#include "certified_planner.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "asked_problem.hpp"
#include "certifying_judge.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/planning/problem_check.hpp"
#include "plan_ladder.hpp"
#include "search/default_planner.hpp"
#include "search/second_opinions.hpp"

namespace limber {

namespace {

/// Of the limits, for the search with the clearance that was asked for, where it finds nothing; the
/// rest is for smaller ones. But never more time than that.
constexpr double kPatience = 0.9;
constexpr double kMaxForSmallerS = 1.0;

constexpr double kMinSearchS = 1e-3;  // a time limit is positive

/// A "search" that knows the answer already.
class WaypointPlanner final : public Planner {
 public:
  WaypointPlanner(const std::vector<Pressures>& waypoints_kpa, const std::string& name)
      : waypoints_kpa_(waypoints_kpa), name_(name) {}

  const char* name() const override { return name_.c_str(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& /*limits*/,
                  std::uint64_t seed, const PlannerCallback& /*callback*/) override {
    const auto start = std::chrono::steady_clock::now();
    const CollisionChecker checker = checker_of(problem);
    MotionSimulator simulator(problem.arm, problem.model, checker);
    std::vector<Pressures> whole = {start_state(problem.environment, problem.arm).setpoint_kpa()};
    whole.insert(whole.end(), waypoints_kpa_.begin(), waypoints_kpa_.end());
    Plan plan = build_plan(problem, simulator, whole, name_, seed);
    PlanResult result;
    result.statistics.queries = simulator.queries();
    result.reason = why_no_solution(problem, checker, plan);
    if (result.reason.empty()) {
      result.status = PlanStatus::solved;
      result.reason = "the motion was given";
      const double found_s = seconds_since(start);
      result.first_solution = FirstSolution{.time_s = found_s,
                                            .cost_kpa = plan.cost_kpa,
                                            .queries = simulator.queries(),
                                            .candidate_s = found_s};
      result.plan = std::move(plan);
    } else {
      result.best_partial = std::move(plan);
    }
    return result;
  }

 private:
  const std::vector<Pressures>& waypoints_kpa_;
  const std::string& name_;
};

void require_waypoints(const PlanningProblem& problem, const std::vector<Pressures>& kpa) {
  refuse_if(kpa.empty(), "no waypoints; expected at least one, to which the motion goes");
  const std::vector<PressureLimits> all_limits = limits_of(problem);
  for (std::size_t w = 0; w < kpa.size(); ++w) {
    if (kpa[w].size() != problem.arm.channel_count()) {
      throw InputError(fmt::format("{} has {} set points; arm '{}' has {} segments",
                                   waypoint_name(w), kpa[w].size(), problem.arm.name,
                                   problem.arm.channel_count()));
    }
    for (Eigen::Index i = 0; i < kpa[w].size(); ++i) {
      const PressureLimits& limits = all_limits[i];
      if (!limits.contains(double(kpa[w][i]))) {  // NaN neither
        throw InputError(fmt::format(
            "{}: {} at {:.6g} {unit}; expected within {} {unit}", waypoint_name(w), segment_name(i),
            kpa[w][i], to_string(limits), fmt::arg("unit", problem.arm.command.unit)));
      }
    }
  }
}

/// The plan along given waypoints, the start left out, if it is free, ends in the goal and is
/// certified; else why it is not.
PlanResult certified_along(const PlanningProblem& problem, AskedProblem& asked,
                           const std::vector<Pressures>& waypoints_kpa, const std::string& planner,
                           std::uint64_t seed) {
  WaypointPlanner given(waypoints_kpa, planner);
  return certified_search(given, problem, asked, {}, seed, {});
}

constexpr double kSmallerClearances[] = {0.75, 0.5, 0.25, 0.0};  // of the one asked for

/// For the first of so many tries: its part of what is left, and never more than its part of what
/// patience keeps back, however early the search ended. None: nothing is left.
std::optional<PlannerLimits> limits_of_try(const PlannerLimits& limits,
                                           const PlannerStatistics& spent, double spent_s,
                                           std::size_t tries) {
  constexpr double kMinLeftS = 0.01;
  constexpr double kRounding = 1e-9;  // relative: whole numbers stay what they are
  const double kept = (1.0 - limits.patience) / double(std::size(kSmallerClearances));
  const auto part = [&](double limit, double used) {
    return std::max(0.0, std::min(kept * limit, (limit - used) / double(tries)));
  };
  const auto count = [&](std::uint64_t limit, std::uint64_t used) {
    const double share = part(double(limit), double(used)) * (1.0 + kRounding);
    return used < limit ? std::max<std::uint64_t>(1, std::uint64_t(share)) : 0;
  };
  PlannerLimits one = limits;
  one.patience = 1.0;
  one.cost_threshold_kpa = std::numeric_limits<double>::max();  // the first will do
  if (limits.time_s) {
    one.time_s = part(*limits.time_s, spent_s);
  }
  if (limits.iterations) {
    one.iterations = count(*limits.iterations, spent.iterations);
  }
  if (limits.queries) {
    one.queries = count(*limits.queries, spent.queries);
  }
  const bool is_spent = (limits.time_s && *limits.time_s - spent_s < kMinLeftS) ||
                        one.iterations == 0 || one.queries == 0;
  return is_spent ? std::nullopt : std::optional(one);
}

/// A plan that was found with less, if it happens to keep what was asked for, by all opinions.
bool keeps_what_was_asked(const PlanningProblem& asked, AskedProblem& shared, const Plan& found,
                          SteadyTime start, PlanResult& result) {
  const CollisionChecker checker = checker_of(asked);
  if (!SecondOpinions(asked, checker).agree(found.waypoints_kpa)) {
    return false;
  }
  const std::vector<Pressures> waypoints_kpa(found.waypoints_kpa.begin() + 1,
                                             found.waypoints_kpa.end());
  PlanResult kept = certified_along(asked, shared, waypoints_kpa, found.planner, found.seed);
  if (!kept.plan) {
    return false;
  }
  kept.first_solution->time_s = seconds_since(start);
  kept.first_solution->queries = result.statistics.queries;
  kept.statistics = result.statistics;
  kept.warnings = std::move(result.warnings);
  kept.reason = "found by a search with less clearance, and keeps what was asked for";
  result = std::move(kept);
  return true;
}

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

PlanResult plan_along(const PlanningProblem& given, const std::vector<Pressures>& waypoints_kpa,
                      const std::string& planner, std::uint64_t seed) {
  const auto start = std::chrono::steady_clock::now();
  require_planar(given.arm, "plan_along");
  require_model_of_arm(given.arm, given.model, "plan_along");
  require_margin(given.margin_m);
  require_goal_margin(given.goal_margin);
  require_limits(given.limits, given.arm);
  require_waypoints(given, waypoints_kpa);
  PlanningProblem problem = given;
  PlanResult result;
  yield_to_start(problem, result.warnings);
  if (is_refused(problem, checker_of(problem), result)) {
    return result;
  }
  AskedProblem asked(problem);
  const std::vector<std::string> notes = std::move(result.warnings);
  result = certified_along(problem, asked, waypoints_kpa, planner, seed);
  result.warnings.insert(result.warnings.begin(), notes.begin(), notes.end());
  if (result.status == PlanStatus::limit) {  // refused before its certificate was asked
    result.status = PlanStatus::not_certified;
  }
  result.statistics.time_s = seconds_since(start);
  return result;
}

void try_smaller_clearances(Planner& planner, const PlanningProblem& asked, AskedProblem& shared,
                            const PlannerLimits& limits, SteadyTime start, std::uint64_t seed,
                            const PlannerCallback& callback, PlanResult& result) {
  const double max_m = asked.tube ? max_room_m(*asked.tube) : asked.margin_m;
  PlanningProblem problem = asked;
  problem.tube.reset();
  problem.on_plan = {};  // these keep less than was asked for
  PlannerStatistics& spent = result.statistics;
  // To whoever watches it is one search, and none of these plans is an answer to what was asked.
  const PlannerCallback watched = [&](PlannerProgress now) {
    now.time_s = seconds_since(start);
    now.iterations += spent.iterations;
    now.queries += spent.queries;
    now.best_cost_kpa.reset();
    return !callback || callback(now);
  };
  std::size_t tries = std::size(kSmallerClearances);
  for (const double share : kSmallerClearances) {
    const std::optional<PlannerLimits> left =
        limits_of_try(limits, spent, seconds_since(start), tries--);
    if (!left) {
      return;
    }
    problem.margin_m = share * max_m;
    const PlanResult tried = certified_search(planner, problem, shared, *left, seed, watched);
    spent.iterations += tried.statistics.iterations;
    spent.queries += tried.statistics.queries;
    if (tried.plan) {
      if (keeps_what_was_asked(asked, shared, *tried.plan, start, result)) {
        return;
      }
      result.max_clearance_m = tried.plan->certified->clearance_m;
      result.reason += fmt::format(
          "; with less clearance than the {:.2f} cm {} there is a plan, which keeps "
          "{:.2f} cm: --margin-m {:.4g}",
          max_m * kCmPerM, asked.tube ? "of the tube" : "asked for",
          *result.max_clearance_m * kCmPerM, problem.margin_m);
      return;
    }
  }
}

std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner, int jobs,
                                                Valves valves) {
  return std::make_unique<CertifiedPlanner>(std::move(planner), jobs, valves);
}

}  // namespace limber
