#include "limber/planning/certified_planner.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "certifying_judge.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/default_planner.hpp"
#include "limber/planning/problem_check.hpp"

namespace limber {

namespace {

// Both far above the rounding of the forward model in float32 over a plan, and far below what
// matters to a plan.
constexpr double kReserveM = Certificate::kDeviationM;
constexpr double kReserveRad = Certificate::kHeadingDeviationRad;
constexpr double kMostOfTolerance = 0.1;
/// Of a tolerance: what plans may use of it where the model's error leaves no room in it.
constexpr double kShareWithoutRoom = 0.8;
/// Of a tolerance: what is aimed at where there is an error to keep room for. That costs little.
constexpr double kAimedShare = 0.25;
/// Of the limits, for the search with the clearance that was asked for, where it finds nothing; the
/// rest is for smaller ones. But never more time than that.
constexpr double kPatience = 0.9;
constexpr double kMostForSmallerS = 1.0;
constexpr double kSmallerClearances[] = {0.75, 0.5, 0.25, 0.0};  // of the one asked for

constexpr double kYield = 0.95;  // of what an arm starts with: it has to get away from there

bool fits(double tolerance, double margin) {
  return margin <= (1.0 - kAimedShare) * tolerance;
}

double with_room(double tolerance, double margin, double reserve) {
  const double inside =
      fits(tolerance, margin) ? tolerance - margin : kShareWithoutRoom * tolerance;
  return inside - std::min(reserve, kMostOfTolerance * inside);
}

Environment with_room(Environment environment, const PoseError& margin) {
  PoseGoal& goal = environment.goal;
  goal.position_tolerance_m = with_room(goal.position_tolerance_m, margin.position_m, kReserveM);
  goal.orientation_tolerance_rad =
      with_room(goal.orientation_tolerance_rad, margin.orientation_rad, kReserveRad);
  return environment;
}

/// What is preferred within that.
std::optional<PoseError> aim_of(const PlanningProblem& problem) {
  if (problem.goal_margin.position_m <= 0.0 && problem.goal_margin.orientation_rad <= 0.0) {
    return std::nullopt;
  }
  const PoseGoal& goal = problem.environment.goal;
  return PoseError{kAimedShare * goal.position_tolerance_m,
                   kAimedShare * goal.orientation_tolerance_rad};
}

/// Whether plans that end where they are to end there also with the model's error.
bool has_room(const PlanningProblem& problem) {
  const PoseGoal& goal = problem.environment.goal;
  return fits(goal.position_tolerance_m, problem.goal_margin.position_m) &&
         (!goal.theta_rad ||
          fits(goal.orientation_tolerance_rad, problem.goal_margin.orientation_rad));
}

double clearance_with_reserve_m(double margin_m) {
  return std::max(margin_m, Certificate::kLeastClearanceM) + kReserveM;
}

/// Where the goal has no room for the error: what is aimed at instead.
std::vector<std::string> warnings_of_aim(const PlanningProblem& problem) {
  const PoseGoal& goal = problem.environment.goal;
  std::vector<std::string> warnings;
  if (!fits(goal.position_tolerance_m, problem.goal_margin.position_m)) {
    warnings.push_back(
        fmt::format("the goal's tolerance of {:.2f} cm leaves little room for the model's error, "
                    "{:.2f} cm: the "
                    "plan aims at its centre, and the arm may end outside",
                    goal.position_tolerance_m * kCmPerM, problem.goal_margin.position_m * kCmPerM));
  }
  if (goal.theta_rad &&
      !fits(goal.orientation_tolerance_rad, problem.goal_margin.orientation_rad)) {
    warnings.push_back(fmt::format(
        "the goal's tolerance of {:.3f} rad leaves little room for the model's error, {:.3f} rad: "
        "the plan aims at its middle, and the arm may end outside",
        goal.orientation_tolerance_rad, problem.goal_margin.orientation_rad));
  }
  return warnings;
}

bool is_refusal(PlanStatus status) {
  return status == PlanStatus::invalid_start || status == PlanStatus::goal_unreachable ||
         status == PlanStatus::goal_in_collision;
}

class CertifiedPlanner final : public Planner {
 public:
  CertifiedPlanner(std::unique_ptr<Planner> planner, Valves valves)
      : planner_(std::move(planner)), valves_(valves) {}

  const char* name() const override { return planner_->name(); }

  PlanResult plan(const PlanningProblem& asked, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    require_margin(asked.margin_m);  // before it is raised to what a certificate asks for
    require_goal_margin(asked.goal_margin);
    const Clock::time_point start = Clock::now();
    PlanningProblem problem = asked;
    if (valves_ == Valves::left_out) {
      problem.model = asked.model.without_valves();
    }
    std::vector<std::string> notes = warnings_of_aim(problem);
    if (problem.margin_yields_to_start) {
      yield_to_start(problem, notes);
    }
    const bool may_keep_less = problem.margin_m > 0.0;
    PlannerLimits patient = limits;
    if (may_keep_less) {
      patient.patience =
          limits.time_s ? std::max(kPatience, 1.0 - kMostForSmallerS / *limits.time_s) : kPatience;
    }
    PlanResult result = search(*planner_, problem, patient, seed, callback);
    result.warnings.insert(result.warnings.begin(), notes.begin(), notes.end());
    if (!result.plan) {
      explain(
          problem, seed, [&] { return limits.time_s && seconds_since(start) > *limits.time_s; },
          result);
      if (may_keep_less && result.status != PlanStatus::not_certified) {
        try_smaller_clearances(problem, limits, start, seed, callback, result);
      }
    }
    result.statistics.time_s = seconds_since(start);
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  static void yield_to_start(PlanningProblem& problem, std::vector<std::string>& notes) {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles);
    const Clearance at_start =
        checker.clearance(start_state(problem.environment, problem.arm).backbone);
    const double most_m = at_start.value_m - kReserveM - Certificate::kClearanceToleranceM;
    if (at_start.obstacle < 0 || most_m <= 0.0 || problem.margin_m <= most_m) {
      return;  // nothing is near, or it starts in an obstacle, which is refused
    }
    notes.push_back(fmt::format(
        "the arm starts {:.2f} cm from {}: plans keep that, instead of the {:.2f} cm that the "
        "model "
        "erred by",
        at_start.value_m * kCmPerM, obstacle_name(problem.environment, at_start.obstacle),
        problem.margin_m * kCmPerM));
    problem.margin_m = kYield * most_m;
  }

  /// `problem`, planned in with a little room and judged as it was asked.
  static PlanResult search(Planner& planner, const PlanningProblem& problem,
                           const PlannerLimits& limits, std::uint64_t seed,
                           const PlannerCallback& callback) {
    const Environment environment = with_room(problem.environment, problem.goal_margin);
    CertifyingJudge judge(problem);
    const PlanningProblem searched{problem.arm,
                                   problem.model,
                                   environment,
                                   clearance_with_reserve_m(problem.margin_m),
                                   {},
                                   aim_of(problem),
                                   problem.stay_within,
                                   &judge,
                                   false,
                                   has_room(problem)};
    PlanResult result = planner.plan(searched, limits, seed, callback);
    if (result.best_partial) {
      judge.name_problem(*result.best_partial);
    }
    judge.report(result);
    return result;
  }

  /// A refusal's amounts are those of the problem as it was asked, wherever it is refused as such;
  /// a search that found nothing says so where it may have had nothing to find.
  static void explain(const PlanningProblem& problem, std::uint64_t seed,
                      const std::function<bool()>& is_late, PlanResult& result) {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
    if (result.status == PlanStatus::limit || result.status == PlanStatus::no_solution) {
      const std::string note = reached_only_in_collision(problem, checker, seed, is_late);
      result.reason += note.empty() ? "" : "; " + note;
      return;
    }
    if (!is_refusal(result.status)) {
      return;
    }
    const ProblemCheck check = check_problem(problem, checker, seed);
    if (check.refusal) {
      result.status = *check.refusal;
      result.reason = check.reason;
    } else if (problem.goal_margin.position_m > 0.0) {
      result.reason += fmt::format(
          "; {:.2f} cm of the tolerance are kept for the model's error: --goal-margin-m 0 keeps "
          "none",
          problem.goal_margin.position_m * kCmPerM);
    }
  }

  static PlannerLimits left_of(const PlannerLimits& limits, const PlannerStatistics& spent,
                               Clock::time_point start) {
    PlannerLimits left = limits;
    if (limits.time_s) {
      left.time_s = *limits.time_s - seconds_since(start);
    }
    if (limits.iterations) {
      left.iterations = *limits.iterations - std::min(*limits.iterations, spent.iterations);
    }
    if (limits.queries) {
      left.queries = *limits.queries - std::min(*limits.queries, spent.queries);
    }
    left.cost_threshold_kpa = std::numeric_limits<double>::max();  // the first will do
    return left;
  }

  static bool is_spent(const PlannerLimits& limits) {
    constexpr double kLeastS = 0.01;
    return (limits.time_s && *limits.time_s < kLeastS) || limits.iterations == 0 ||
           limits.queries == 0;
  }

  /// Names in `result` the largest clearance with which there is a plan, found with what `limits`
  /// leave of the time since `start`.
  static void try_smaller_clearances(const PlanningProblem& asked, const PlannerLimits& limits,
                                     Clock::time_point start, std::uint64_t seed,
                                     const PlannerCallback& callback, PlanResult& result) {
    const std::unique_ptr<Planner> planner = make_default_planner();
    PlanningProblem problem = asked;
    PlannerStatistics& spent = result.statistics;
    std::size_t tries = std::size(kSmallerClearances);
    for (const double share : kSmallerClearances) {
      const PlannerLimits left = left_of(limits, spent, start);
      if (is_spent(left)) {
        return;
      }
      problem.margin_m = share * asked.margin_m;
      const PlanResult tried =
          search(*planner, problem, part_of(left, double(tries--)), seed, callback);
      spent.iterations += tried.statistics.iterations;
      spent.queries += tried.statistics.queries;
      if (tried.plan) {
        result.largest_clearance_m = tried.plan->certified->clearance_m;
        result.reason += fmt::format(
            "; with less clearance than the {:.2f} cm asked for there is a plan, which keeps "
            "{:.2f} cm: --margin-m {:.4g}",
            asked.margin_m * kCmPerM, *result.largest_clearance_m * kCmPerM, problem.margin_m);
        return;
      }
    }
  }

  /// An equal part of what is left for each of so many tries.
  static PlannerLimits part_of(PlannerLimits limits, double tries) {
    const auto part = [&](std::optional<std::uint64_t>& count) {
      if (count) {
        count = std::max<std::uint64_t>(1, std::uint64_t(double(*count) / tries));
      }
    };
    if (limits.time_s) {
      limits.time_s = *limits.time_s / tries;
    }
    part(limits.iterations);
    part(limits.queries);
    return limits;
  }

  std::unique_ptr<Planner> planner_;
  Valves valves_;
};

}  // namespace

std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner, Valves valves) {
  return std::make_unique<CertifiedPlanner>(std::move(planner), valves);
}

}  // namespace limber
