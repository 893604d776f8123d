#include "asked_problem.hpp"

#include <algorithm>

#include <fmt/format.h>

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

constexpr double kMaxGoalReserve = 0.1;  // of a tolerance
/// Share of a tolerance that plans may use if the model's error leaves no room in it.
constexpr double kShareWithoutRoom = 0.8;
/// Share of a tolerance that has to be left beside the model's error, else it does not fit.
constexpr double kMinShare = 0.25;
/// Share of a tolerance that plans aim at if there is an error to keep room for. Cheap plans end on
/// the aim's rim, which has to be near to the centre beside the error itself (docs/planning.md).
constexpr double kAimedShare = 0.1;

bool fits(double tolerance, double margin) {
  return margin <= (1.0 - kMinShare) * tolerance;
}

double with_room(double tolerance, double margin, double reserve) {
  const double inside =
      fits(tolerance, margin) ? tolerance - margin : kShareWithoutRoom * tolerance;
  return inside - std::min(reserve, kMaxGoalReserve * inside);
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
    return;  // nothing is near, the margin fits, or it starts in an obstacle, which is refused
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

Environment with_room(Environment environment, const PoseError& margin) {
  PoseGoal& goal = environment.goal;
  goal.position_tolerance_m = with_room(goal.position_tolerance_m, margin.position_m, kReserveM);
  goal.orientation_tolerance_rad =
      with_room(goal.orientation_tolerance_rad, margin.orientation_rad, kReserveRad);
  return environment;
}

std::optional<PoseError> aim_of(const PlanningProblem& problem) {
  if (problem.goal_margin.position_m <= 0.0 && problem.goal_margin.orientation_rad <= 0.0) {
    return std::nullopt;
  }
  const PoseGoal& goal = problem.environment.goal;
  return PoseError{kAimedShare * goal.position_tolerance_m,
                   kAimedShare * goal.orientation_tolerance_rad};
}

bool has_room(const PlanningProblem& problem) {
  const PoseGoal& goal = problem.environment.goal;
  return fits(goal.position_tolerance_m, problem.goal_margin.position_m) &&
         (!goal.theta_rad ||
          fits(goal.orientation_tolerance_rad, problem.goal_margin.orientation_rad));
}

std::optional<PlanTube> tube_of_plans(const PlanningProblem& problem) {
  std::optional<PlanTube> tube = problem.tube;
  if (tube) {
    tube->goal_inside = has_room(problem) && problem.goal_margin.position_m >= tube->end_radius_m &&
                        (!problem.environment.goal.theta_rad ||
                         problem.goal_margin.orientation_rad >= tube->end_heading_rad);
  }
  return tube;
}

double max_room_m(const PlanTube& tube) {
  return *std::max_element(tube.plate_radius_m.begin(), tube.plate_radius_m.end());
}

std::vector<std::string> warnings_of_aim(const PlanningProblem& problem) {
  const PoseGoal& goal = problem.environment.goal;
  std::vector<std::string> warnings;
  if (!fits(goal.position_tolerance_m, problem.goal_margin.position_m)) {
    warnings.push_back(
        fmt::format("the goal's tolerance of {:.2f} cm leaves little room for the model's error, "
                    "{:.2f} cm: the plan aims at its centre, and the arm may end outside",
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

}  // namespace limber
