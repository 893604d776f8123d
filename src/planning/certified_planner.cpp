#include "limber/planning/certified_planner.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "limber/planning/problem_check.hpp"

namespace limber {

namespace {

// Both far above the rounding of the forward model in float32 over a plan, and far below what
// matters to a plan.
constexpr double kReserveM = Certificate::kDeviationM;
constexpr double kReserveRad = Certificate::kHeadingDeviationRad;
constexpr double kMostOfTolerance = 0.1;

Environment with_reserve(Environment environment) {
  PoseGoal& goal = environment.goal;
  goal.position_tolerance_m -= std::min(kReserveM, kMostOfTolerance * goal.position_tolerance_m);
  goal.orientation_tolerance_rad -=
      std::min(kReserveRad, kMostOfTolerance * goal.orientation_tolerance_rad);
  return environment;
}

class CertifiedPlanner final : public Planner {
 public:
  CertifiedPlanner(std::unique_ptr<Planner> planner, Valves valves)
      : planner_(std::move(planner)), valves_(valves) {}

  const char* name() const override { return planner_->name(); }

  PlanResult plan(const PlanningProblem& asked, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    require_margin(asked.margin_m);  // before it is raised to what a certificate asks for
    const PlanningProblem problem{
        asked.arm, valves_ == Valves::left_out ? asked.model.without_valves() : asked.model,
        asked.environment, asked.margin_m};
    const Environment environment = with_reserve(problem.environment);
    const double margin_m = std::max(problem.margin_m, Certificate::kLeastClearanceM) + kReserveM;
    PlanResult result =
        planner_->plan({problem.arm, problem.model, environment, margin_m}, limits, seed, callback);
    for (std::optional<Plan>* plan : {&result.plan, &result.best_partial}) {
      if (*plan) {
        (*plan)->environment_hash = environment_hash(problem.environment);
        (*plan)->margin_m = problem.margin_m;
      }
    }
    if (result.plan) {
      judge(problem, result);
    } else {
      explain(problem, seed, result);
    }
    return result;
  }

 private:
  /// A refusal's amounts are those of the problem as it was asked, wherever it is refused as such;
  /// a search that found nothing says so where it may have had nothing to find.
  static void explain(const PlanningProblem& problem, std::uint64_t seed, PlanResult& result) {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
    if (result.status == PlanStatus::limit || result.status == PlanStatus::no_solution) {
      const std::string note = reached_only_in_collision(problem, checker, seed);
      result.reason += note.empty() ? "" : "; " + note;
      return;
    }
    if (result.status != PlanStatus::invalid_start &&
        result.status != PlanStatus::goal_unreachable &&
        result.status != PlanStatus::goal_in_collision) {
      return;
    }
    const ProblemCheck check = check_problem(problem, checker, seed);
    if (check.refusal) {
      result.status = *check.refusal;
      result.reason = check.reason;
    }
  }

  static void judge(const PlanningProblem& problem, PlanResult& result) {
    const auto start = std::chrono::steady_clock::now();
    const CompensationModel* network =
        problem.model.has_network() ? &problem.model.compensation() : nullptr;
    result.certificate = certify(*result.plan, problem.arm, network,
                                 problem.model.valves().parameters(), problem.environment);
    const Certificate& certificate = *result.certificate;
    if (certificate.certified()) {
      result.plan->certified =
          CertifiedFigures{certificate.clearance_m, certificate.largest_deviation_m};
    } else {
      const CertificateFailure& first = certificate.failures.front();
      result.status = PlanStatus::not_certified;
      result.reason = fmt::format(
          "the plan that planner '{}' returned is refused by its certificate: {}: frame {}: {}; if "
          "it is not the model's fault it is the planner's: please report it with arm, model, "
          "environment and seed {}",
          result.plan->planner, first.check, first.frame, first.message, result.plan->seed);
      result.best_partial = std::move(result.plan);
      result.plan.reset();
      result.events.clear();
    }
    result.statistics.time_s +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  std::unique_ptr<Planner> planner_;
  Valves valves_;
};

}  // namespace

std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner, Valves valves) {
  return std::make_unique<CertifiedPlanner>(std::move(planner), valves);
}

}  // namespace limber
