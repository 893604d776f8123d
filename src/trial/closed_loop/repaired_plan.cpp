#include "repaired_plan.hpp"

#include <algorithm>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/plan_builder.hpp"
#include "plan_repair.hpp"

namespace limber {

namespace {

constexpr double kOfClearanceNow = 0.9;   // where that is less than the margin
constexpr double kRepairReserveM = 2e-4;  // float32 searches, double certifies

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

std::optional<Plan> repaired_plan(PlanningProblem problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check) {
  const MotionState from = start_of(problem);
  const std::vector<Obstacle>& obstacles = problem.environment.obstacles;
  const double start_m = CollisionChecker(problem.arm, obstacles).clearance(from.backbone).value_m;
  problem.margin_m = std::max(0.0, std::min(problem.margin_m, kOfClearanceNow * start_m));
  const CollisionChecker checker(
      problem.arm, obstacles,
      std::max(problem.margin_m, Certificate::kMinClearanceM) + kRepairReserveM);
  MotionSimulator simulator(problem.arm, problem.model, checker);
  PlanRepair repair(simulator, setpoints_of(problem));
  const std::optional<std::vector<Pressures>> shifted_kpa =
      repair.toward(problem.environment.goal, from, waypoints_kpa, max_error_m);
  if (!shifted_kpa) {
    return std::nullopt;
  }
  Plan found = build_plan(problem, simulator, *shifted_kpa, "repair", seed);
  return check(found, problem.environment) ? std::optional(std::move(found)) : std::nullopt;
}

}  // namespace limber
