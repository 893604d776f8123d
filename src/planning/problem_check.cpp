#include "limber/planning/problem_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "limber/world/start_shape.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kCheckStream = 0x636865636bULL;  // apart from the planners' streams
constexpr double kOtherUnit = 10.0;  // arm lengths: a goal beyond them is hardly in metres

std::string margin_note(const PlanningProblem& problem) {
  if (problem.tube) {
    return fmt::format(" (tube of {:.4g} % of runs included)", 100.0 * problem.tube->level);
  }
  return problem.margin_m > 0.0
             ? fmt::format(" (margin of {:.2f} cm included)", problem.margin_m * kCmPerM)
             : std::string();
}

/// Half width that the tip has anywhere in the goal's disc. Of a tube that grows, the tip's own
/// room where the disc is nearest to its start: the plate before it may have any.
double min_tip_radius_m(const PlanningProblem& problem, const CollisionChecker& checker) {
  const int gap = problem.arm.point_count() - 2;
  if (!problem.tube || problem.tube->growth.is_constant()) {
    return checker.radius_m(gap);
  }
  const PoseGoal& goal = problem.environment.goal;
  const Pose tip = tip_pose(start_state(problem.environment, problem.arm).backbone);
  const double moved_m = std::hypot(goal.x_m - tip.x_m, goal.y_m - tip.y_m);
  const double min_moved_m = std::max(0.0, moved_m - goal.position_tolerance_m);
  const std::vector<double>& full_m = problem.tube->plate_radius_m;
  return checker.radius_m(gap) - std::max(full_m[gap], full_m[gap + 1]) +
         full_m[gap + 1] * problem.tube->growth.share_after(min_moved_m);
}

/// Refused where no point of the goal's disc is far enough from some one obstacle: the distance to
/// an obstacle rises by at most the tolerance within it.
void check_goal_clearance(const PlanningProblem& problem, const CollisionChecker& checker,
                          ProblemCheck& result) {
  const Environment& environment = problem.environment;
  const PoseGoal& goal = environment.goal;
  const double tip_radius = min_tip_radius_m(problem, checker);
  for (std::size_t i = 0; i < environment.obstacles.size(); ++i) {
    const ObstacleShape shape = make_obstacle_shape(environment.obstacles[i], int(i));
    const double distance = signed_distance(shape, Eigen::Vector2d(goal.x_m, goal.y_m));
    const double missing = tip_radius - distance - goal.position_tolerance_m;
    if (missing > 0.0) {
      result.refusal = PlanStatus::goal_in_collision;
      result.reason = fmt::format(
          "the goal ({:.3f}, {:.3f}) m is {:.2f} cm {} {}; the tip, {:.2f} cm thick to each side"
          "{}, can't be there: even at the edge of the tolerance {:.2f} cm are missing",
          goal.x_m, goal.y_m, std::abs(distance) * kCmPerM, distance < 0.0 ? "inside" : "away from",
          obstacle_name(environment, int(i)), tip_radius * kCmPerM, margin_note(problem),
          missing * kCmPerM);
      return;
    }
  }
}

void check_goal_reach(const PlanningProblem& problem, ProblemCheck& result) {
  const PoseGoal& goal = problem.environment.goal;
  const double distance = std::hypot(goal.x_m, goal.y_m);
  const double beyond = distance - goal.position_tolerance_m - problem.arm.length_m();
  if (beyond > 0.0) {
    result.refusal = PlanStatus::goal_unreachable;
    if (distance > kOtherUnit * problem.arm.length_m()) {
      result.reason = fmt::format(
          "goal.x_m = {:.6g} and goal.y_m = {:.6g} are {:.6g} m from the base, and the arm is "
          "{:.4g} m long: expected a goal in metres, within the arm's reach. Is it in millimetres?",
          goal.x_m, goal.y_m, distance, problem.arm.length_m());
      return;
    }
    result.reason = fmt::format(
        "the goal ({:.3f}, {:.3f}) m is {:.2f} cm beyond the arm's reach: {:.1f} cm from the base, "
        "the arm is {:.1f} cm long, the tolerance {:.2f} cm",
        goal.x_m, goal.y_m, beyond * kCmPerM, distance * kCmPerM, problem.arm.length_m() * kCmPerM,
        goal.position_tolerance_m * kCmPerM);
  }
}

/// A plan's first set points are the start's: they have to be within its limits.
void check_start_limits(const PlanningProblem& problem, ProblemCheck& result) {
  const Pressures start_kpa = start_state(problem.environment, problem.arm).setpoint_kpa();
  const std::vector<PressureLimits> limits = limits_of(problem);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double value = start_kpa[Eigen::Index(i)];
    if (!limits[i].contains(value)) {
      result.refusal = PlanStatus::invalid_start;
      result.reason = fmt::format(
          "the arm starts with {} at {:.6g} {unit}; the limits to plan within are {} {unit}: widen "
          "them, or move the start",
          segment_name(Eigen::Index(i)), value, to_string(limits[i]),
          fmt::arg("unit", problem.arm.command.unit));
      return;
    }
  }
}

/// Empty: an arm can have it.
std::string shape_fault(const char* key, const Backbone& shape, const ArmDescription& arm) {
  const std::optional<StartFault> fault = find_start_fault(shape, arm);
  return fault ? fmt::format("start.{}[{}]: {}", key, fault->row, fault->message) : "";
}

void check_start(const PlanningProblem& problem, const CollisionChecker& checker,
                 ProblemCheck& result) {
  if (const std::optional<ArmStart>& given = problem.environment.start) {
    result.reason = shape_fault("backbone", given->backbone, problem.arm);
    if (result.reason.empty() && given->before.rows() > 0) {
      result.reason = shape_fault("backbone_before", given->before, problem.arm);
    }
    if (!result.reason.empty()) {
      result.refusal = PlanStatus::invalid_start;
      return;
    }
  }
  const Clearance clearance =
      checker.clearance(start_state(problem.environment, problem.arm).backbone);
  if (clearance.value_m <= 0.0) {
    result.refusal = PlanStatus::invalid_start;
    result.reason = fmt::format(
        "the arm starts {:.2f} cm deep in {}, {}{}: move the obstacle or the start",
        -clearance.value_m * kCmPerM, obstacle_name(problem.environment, clearance.obstacle),
        gap_name(problem.arm, clearance.gap), margin_note(problem));
  }
}

}  // namespace

std::string reached_only_in_collision(const PlanningProblem& problem,
                                      const CollisionChecker& checker, std::uint64_t seed,
                                      const std::function<bool()>& give_up) {
  if (give_up && give_up()) {
    return "";
  }
  RandomStream random(seed, kCheckStream);
  InverseKinematicsSettings settings;
  settings.starts = 200;
  settings.max_solutions = 50;
  settings.limits = problem.limits;
  settings.give_up = give_up;
  const InverseKinematicsResult found =
      solve_inverse_kinematics(problem.model.no_load(), problem.environment.goal, settings, random);
  if (!found.reachable()) {
    return "";
  }
  Clearance best{-std::numeric_limits<double>::infinity(), -1, -1};
  BackboneD shape(problem.arm.point_count(), kPoseSize);
  for (const Eigen::VectorXd& kpa : found.pressures_kpa) {
    problem.model.no_load().backbone(kpa, shape);
    if ((give_up && give_up()) || checker.is_free(shape)) {
      return "";
    }
    const Clearance clearance = checker.clearance(shape);
    best = clearance.value_m > best.value_m ? clearance : best;
  }
  if (best.obstacle < 0) {
    return "";  // they are no shapes, and collide with nothing that has a name
  }
  return fmt::format(
      "the no-load model reaches the goal only in collision: of {} configurations the least deep "
      "is {:.2f} cm in {}, {}{}; the arm may differ",
      found.pressures_kpa.size(), -best.value_m * kCmPerM,
      obstacle_name(problem.environment, best.obstacle), gap_name(problem.arm, best.gap),
      margin_note(problem));
}

void require_margin(double margin_m) {
  refuse_if(!(margin_m >= 0.0 && margin_m <= kMaxMarginM),
            "margin_m = {}; expected a distance in metres, 0 to {}", margin_m, kMaxMarginM);
}

void require_goal_margin(const PoseError& margin) {
  for (const double one : {margin.position_m, margin.orientation_rad}) {
    refuse_if(!(one >= 0.0 && one <= kMaxMarginM), "goal margin of {}; expected a number, 0 to {}",
              one, kMaxMarginM);
  }
}

void require_limits(const std::vector<PressureLimits>& limits, const ArmDescription& arm) {
  refuse_if(!limits.empty() && int(limits.size()) != arm.channel_count(),
            "limits of {} segments; arm '{}' has {}", limits.size(), arm.name, arm.channel_count());
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const PressureLimits& own = arm.segments[i].pressure_limit_kpa;
    const bool has_width = limits[i].lower_kpa < limits[i].upper_kpa;
    if (!has_width || !own.contains(limits[i])) {
      throw InputError(
          fmt::format("limits of {} to plan within: {} {unit}; expected "
                      "lower < upper, both within the arm's {} {unit}",
                      segment_name(Eigen::Index(i)), to_string(limits[i]), to_string(own),
                      fmt::arg("unit", arm.command.unit)));
    }
  }
}

ProblemCheck find_refusal(const PlanningProblem& problem, const CollisionChecker& checker) {
  ProblemCheck result;
  require_limits(problem.limits, problem.arm);
  check_start_limits(problem, result);
  if (!result.refusal) {
    check_start(problem, checker, result);
  }
  if (!result.refusal) {
    check_goal_reach(problem, result);
  }
  if (!result.refusal) {
    check_goal_clearance(problem, checker, result);
  }
  return result;
}

std::vector<std::string> find_warnings(const PlanningProblem& problem, std::uint64_t seed) {
  if (problem.model.no_load().kind() == NoLoadKind::straight) {
    return {};  // it reaches no goal at all, which says nothing of the arm
  }
  RandomStream random(seed, kCheckStream);
  InverseKinematicsSettings settings;
  settings.max_solutions = 1;
  settings.limits = problem.limits;
  const InverseKinematicsResult found =
      solve_inverse_kinematics(problem.model.no_load(), problem.environment.goal, settings, random);
  if (found.reachable()) {
    return {};
  }
  return {fmt::format(
      "the no-load model reaches no closer to the goal than {:.1f} cm and {:.2f} rad (from {} "
      "starts); the arm may differ",
      found.best_error.position_m * kCmPerM, found.best_error.orientation_rad, found.starts_used)};
}

ProblemCheck check_problem(const PlanningProblem& problem, const CollisionChecker& checker,
                           std::uint64_t seed) {
  ProblemCheck result = find_refusal(problem, checker);
  if (!result.refusal) {
    result.warnings = find_warnings(problem, seed);
  }
  return result;
}

}  // namespace limber
