#include "asked_problem.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "goal_room.hpp"
#include "limber/common/units.hpp"
#include "limber/planning/problem_check.hpp"

namespace limber {

namespace {

constexpr double kYield = 0.95;  // of what an arm starts with: it has to get away from there

/// Where the arm starts with an obstacle in its tube, plans keep one
/// clearance everywhere instead.
void leave_tube_at_start(PlanningProblem& problem, const Backbone& start, double max_m,
                         std::vector<std::string>& notes) {
  const double inside_m = checker_of(problem).clearance(start).value_m;
  if (inside_m > 2.0 * kReserveM + Certificate::kClearanceToleranceM) {
    return;
  }
  problem.margin_m = std::min(max_m, max_room_m(*problem.tube));
  notes.push_back(fmt::format(
      "the arm starts with an obstacle in its {:.4g} % tube: plans keep {:.2f} cm everywhere "
      "instead of the tube, and nothing is promised of them",
      100.0 * problem.tube->level, problem.margin_m * kCmPerM));
  problem.tube.reset();
}

}  // namespace

void yield_to_start(PlanningProblem& problem, std::vector<std::string>& notes) {
  if (!problem.margin_yields_to_start) {
    return;
  }
  const CollisionChecker checker(problem.arm, problem.environment.obstacles);
  const Backbone start = start_state(problem.environment, problem.arm).backbone;
  const Clearance at_start = checker.clearance(start);
  const double max_m = at_start.value_m - kReserveM - Certificate::kClearanceToleranceM;
  if (at_start.obstacle < 0 || max_m <= 0.0 || problem.margin_m <= max_m) {
    if (at_start.obstacle >= 0 && max_m > 0.0 && problem.tube) {
      leave_tube_at_start(problem, start, kYield * max_m, notes);
    }
    return;  // nothing is near, or it starts in an obstacle, which is refused
  }
  notes.push_back(
      fmt::format("the arm starts {:.2f} cm from {}: plans keep that "
                  "distance instead of the model's error, {:.2f} cm",
                  at_start.value_m * kCmPerM, obstacle_name(problem.environment, at_start.obstacle),
                  problem.margin_m * kCmPerM));
  problem.margin_m = kYield * max_m;
}

const Certifier& AskedProblem::certifier() {
  if (!certifier_) {
    certifier_.emplace(problem_.arm,
                       problem_.model.has_network() ? &problem_.model.compensation() : nullptr,
                       problem_.model.valves().parameters(), problem_.environment);
  }
  return *certifier_;
}

const std::string& AskedProblem::environment_hash() {
  if (environment_hash_.empty()) {
    environment_hash_ = certifier_ ? certifier_->environment_hash()
                                   : limber::environment_hash(problem_.environment);
  }
  return environment_hash_;
}

}  // namespace limber
