#include "limber/lab/environment_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kMeasureStream = 0x6d656173ULL;
constexpr double kPositionToleranceM = 0.02;  // these three as in limber's own environments
constexpr double kOrientationToleranceRad = 0.3;
constexpr double kOrientationShare = 0.3;  // of environments whose goal asks for a heading

/// Moves straight to `to_kpa` and holds; none if that collides.
std::optional<Backbone> end_of_straight_line(const PlanningProblem& problem,
                                             MotionSimulator& simulator, const Pressures& to_kpa) {
  MotionState there;
  MotionState held;
  if (!simulator.move(start_of(problem), to_kpa, there) || !simulator.hold(there, held)) {
    return std::nullopt;
  }
  return held.backbone;
}

}  // namespace

double size_unit(const ArmDescription& arm) {
  return arm.length_m() / 0.705;
}

Obstacle random_obstacle(double unit, const Eigen::Vector2d& at, RandomStream& random) {
  switch (random.index(3)) {
    case 0:
      return Circle{at.x(), at.y(), unit * random.uniform(0.015, 0.07)};
    case 1:
      return Rectangle{at.x(), at.y(), unit * random.uniform(0.02, 0.08),
                       unit * random.uniform(0.05, 0.25), random.uniform(0.0, std::numbers::pi)};
    default:
      break;
  }
  Polygon polygon;  // star-shaped about its middle, so simple
  const int corners = 3 + int(random.index(4));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.0, 0.6)) / corners;
    const double radius = unit * random.uniform(0.02, 0.09);
    polygon.points_m.emplace_back(at.x() + radius * std::cos(angle),
                                  at.y() + radius * std::sin(angle));
  }
  return polygon;
}

PoseGoal random_goal(const Pose& tip, RandomStream& random) {
  PoseGoal goal{.x_m = tip.x_m,
                .y_m = tip.y_m,
                .position_tolerance_m = kPositionToleranceM,
                .orientation_tolerance_rad = kOrientationToleranceRad};
  if (random.uniform() < kOrientationShare) {
    goal.theta_rad = std::remainder(tip.theta_rad, 2.0 * std::numbers::pi);
  }
  return goal;
}

bool straight_line_collides(const PlanningProblem& problem, const Pressures& to_kpa) {
  const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
  MotionSimulator simulator(problem.arm, problem.model, checker);
  return !end_of_straight_line(problem, simulator, to_kpa);
}

bool straight_line_solves(const PlanningProblem& problem, const std::vector<Pressures>& to_kpa,
                          int starts, std::uint64_t seed) {
  const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
  MotionSimulator simulator(problem.arm, problem.model, checker);
  RandomStream random(seed, kMeasureStream);
  InverseKinematicsSettings settings;
  settings.starts = starts;
  settings.max_solutions = starts;
  std::vector<Pressures> candidates = to_kpa;
  for (const Eigen::VectorXd& q :
       solve_inverse_kinematics(problem.model.no_load(), problem.environment.goal, settings, random)
           .pressures_kpa) {
    candidates.emplace_back(q.cast<float>());
  }
  return std::any_of(candidates.begin(), candidates.end(), [&](const Pressures& q) {
    const std::optional<Backbone> end = end_of_straight_line(problem, simulator, q);
    const PoseGoal& goal = problem.environment.goal;
    return end && is_within(goal, pose_error(goal, tip_pose(*end)));
  });
}

}  // namespace limber
