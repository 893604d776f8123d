#include "checked_plans.hpp"

#include <algorithm>
#include <utility>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/plan_builder.hpp"

namespace limber {

namespace {

constexpr double kOfClearanceNow = 0.9;     // where that is less than the margin
constexpr double kRoundingReserveM = 2e-4;  // float32 searches, double certifies

PlanningProblem with_kept_margin(PlanningProblem problem, const Backbone& now) {
  const double now_m =
      CollisionChecker(problem.arm, problem.environment.obstacles).clearance(now).value_m;
  problem.margin_m = std::max(0.0, std::min(problem.margin_m, kOfClearanceNow * now_m));
  return problem;
}

}  // namespace

PlanCheck certificate_check(const ArmDescription& arm, const MotionModel& model) {
  return [&arm, &model](Plan& plan, const Environment& environment) {
    const Certificate certificate =
        certify(plan, arm, model.has_network() ? &model.compensation() : nullptr,
                model.valves().parameters(), environment);
    if (certificate.certified()) {
      plan.certified = CertifiedFigures{certificate.clearance_m, certificate.max_deviation_m};
    }
    return certificate.certified();
  };
}

CheckedPlans::CheckedPlans(const PlanningProblem& problem, PlanCheck check)
    : from_(start_of(problem)),
      problem_(with_kept_margin(problem, from_.backbone)),
      check_(std::move(check)),
      checker_(problem_.arm, problem_.environment.obstacles,
               std::max(problem_.margin_m, Certificate::kMinClearanceM) + kRoundingReserveM),
      simulator_(problem_.arm, problem_.model, checker_) {}

std::optional<MotionState> CheckedPlans::end_of(const std::vector<Pressures>& waypoints_kpa) {
  MotionState state = from_;
  for (std::size_t w = 1; w < waypoints_kpa.size(); ++w) {
    if (!simulator_.move(state, waypoints_kpa[w], state)) {
      return std::nullopt;
    }
  }
  return simulator_.hold(state, state) ? std::optional(std::move(state)) : std::nullopt;
}

std::optional<Plan> CheckedPlans::checked(const std::vector<Pressures>& waypoints_kpa,
                                          const std::string& planner, std::uint64_t seed) {
  Plan plan = build_plan(problem_, simulator_, waypoints_kpa, planner, seed);
  return check_(plan, problem_.environment) ? std::optional(std::move(plan)) : std::nullopt;
}

}  // namespace limber
