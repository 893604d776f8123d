#pragma once

#include <optional>

#include "limber/world/plan.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// When a tip came into the goal's region for good.
class GoalTime {
 public:
  explicit GoalTime(const PoseGoal& goal) : goal_(goal) {}

  void see(double time_s, const Pose& tip) {
    if (!is_within(goal_, pose_error(goal_, tip))) {
      inside_since_s_.reset();
    } else if (!inside_since_s_) {
      inside_since_s_ = time_s;
    }
  }

  /// None: it is not in there.
  std::optional<double> inside_since_s() const { return inside_since_s_; }

 private:
  const PoseGoal& goal_;
  std::optional<double> inside_since_s_;
};

/// Of a plan's predicted tip.
inline std::optional<double> planned_goal_time_s(const PoseGoal& goal, const Plan& plan) {
  GoalTime time(goal);
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    time.see(double(k) / plan.frame_rate_hz,
             tip_pose(plan.frames[k].backbone.cast<double>().eval()));
  }
  return time.inside_since_s();
}

}  // namespace limber
