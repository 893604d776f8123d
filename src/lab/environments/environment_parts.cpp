#include "environment_parts.hpp"

#include <cmath>
#include <numbers>

namespace limber {

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
  const int corners = 3 + static_cast<int>(random.index(4));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.0, 0.6)) / corners;
    const double radius = unit * random.uniform(0.02, 0.09);
    polygon.points_m.emplace_back(at.x() + radius * std::cos(angle),
                                  at.y() + radius * std::sin(angle));
  }
  return polygon;
}

PoseGoal random_goal(const Pose& tip, double position_tolerance_m, double orientation_tolerance_rad,
                     double orientation_share, RandomStream& random) {
  PoseGoal goal;
  goal.x_m = tip.x_m;
  goal.y_m = tip.y_m;
  goal.position_tolerance_m = position_tolerance_m;
  goal.orientation_tolerance_rad = orientation_tolerance_rad;
  if (random.uniform() < orientation_share) {
    goal.theta_rad = std::remainder(tip.theta_rad, 2.0 * std::numbers::pi);
  }
  return goal;
}

}  // namespace limber
