#include "limber/world/pose_goal.hpp"

#include <cmath>
#include <numbers>

namespace limber {

PoseError pose_error(const PoseGoal& goal, const Pose& pose) {
  return {std::hypot(goal.x_m - pose.x_m, goal.y_m - pose.y_m),
          goal.theta_rad
              ? std::abs(std::remainder(*goal.theta_rad - pose.theta_rad, 2.0 * std::numbers::pi))
              : 0.0};
}

bool is_within(const PoseGoal& goal, const PoseError& error) {
  return error.position_m <= goal.position_tolerance_m &&
         error.orientation_rad <= (goal.theta_rad ? goal.orientation_tolerance_rad : 0.0);
}

}  // namespace limber
