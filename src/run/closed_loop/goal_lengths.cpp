#include "goal_lengths.hpp"

#include <cmath>
#include <numbers>

namespace limber {

double m_per_rad(const PoseGoal& goal) {
  return goal.theta_rad ? goal.position_tolerance_m / goal.orientation_tolerance_rad : 0.0;
}

double as_length_m(const PoseGoal& goal, const PoseError& error) {
  return std::hypot(error.position_m, m_per_rad(goal) * error.orientation_rad);
}

Eigen::Vector3d missing_m(const PoseGoal& goal, const Pose& tip) {
  const double turn = goal.theta_rad
                          ? std::remainder(*goal.theta_rad - tip.theta_rad, 2.0 * std::numbers::pi)
                          : 0.0;
  return {goal.x_m - tip.x_m, goal.y_m - tip.y_m, m_per_rad(goal) * turn};
}

}  // namespace limber
