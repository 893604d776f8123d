#include "limber/lab/environment_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

using Eigen::Vector2d;

constexpr std::uint64_t kMeasureStream = 0x6d656173ULL;
constexpr double kNone = std::numeric_limits<double>::infinity();

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Distance along the unit direction from p to the outline of an obstacle, +∞ if it is not met.
double ray_distance(const ObstacleShape& shape, const Vector2d& p, const Vector2d& direction) {
  if (shape.is_circle()) {
    const Vector2d to_centre = shape.centre - p;
    const double along = to_centre.dot(direction);
    const double square = shape.radius_m * shape.radius_m - to_centre.squaredNorm() + along * along;
    const double distance = square >= 0.0 ? along - std::sqrt(square) : -1.0;
    return distance >= 0.0 ? distance : kNone;
  }
  double nearest = kNone;
  const Vector2d* previous = &shape.vertices.back();
  for (const Vector2d& corner : shape.vertices) {
    const Vector2d edge = corner - *previous;
    const double turn = cross(direction, edge);
    if (turn != 0.0) {
      const double distance = cross(*previous - p, edge) / turn;
      const double on_edge = cross(*previous - p, direction) / turn;
      if (distance >= 0.0 && on_edge >= 0.0 && on_edge <= 1.0) {
        nearest = std::min(nearest, distance);
      }
    }
    previous = &corner;
  }
  return nearest;
}

double ray_distance(const std::vector<ObstacleShape>& shapes, const Vector2d& p,
                    const Vector2d& direction) {
  double nearest = kNone;
  for (const ObstacleShape& shape : shapes) {
    nearest = std::min(nearest, ray_distance(shape, p, direction));
  }
  return nearest;
}

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

std::optional<Passage> narrowest_passage(const ArmDescription& arm, const Environment& environment,
                                         const std::vector<PlanFrame>& frames) {
  std::vector<ObstacleShape> shapes;
  for (std::size_t i = 0; i < environment.obstacles.size(); ++i) {
    shapes.push_back(make_obstacle_shape(environment.obstacles[i], static_cast<int>(i)));
  }
  std::optional<Passage> narrowest;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Backbone& backbone = frames[k].backbone;
    for (int plate = 1; plate < arm.point_count(); ++plate) {
      const Vector2d p(backbone(plate, 0), backbone(plate, 1));
      const double theta = backbone(plate, 2);
      const Vector2d left(-std::sin(theta), std::cos(theta));
      const double to_left = ray_distance(shapes, p, left);
      const double to_right = ray_distance(shapes, p, -left);
      if (std::max(to_left, to_right) > arm.length_m()) {
        continue;
      }
      const Segment& segment =
          arm.segments[static_cast<std::size_t>(arm.segment_of_gap(plate - 1))];
      const Passage here{to_left + to_right, segment.width_m + 2.0 * arm.actuator_radius_m,
                         static_cast<int>(k), plate};
      if (!narrowest ||
          here.width_m / here.arm_width_m < narrowest->width_m / narrowest->arm_width_m) {
        narrowest = here;
      }
    }
  }
  return narrowest;
}

double reversal_kpa(const std::vector<PlanFrame>& frames) {
  return path_cost_kpa(frames, &PlanFrame::setpoint_kpa) -
         motion_cost_kpa(frames.front().setpoint_kpa, frames.back().setpoint_kpa);
}

}  // namespace limber
