#pragma once

#include "limber/forward/motion_model.hpp"
#include "shape_feedback.hpp"

namespace limber {

/// Leads an arm along a plan: set points from the plan and a ShapeFeedback, and how far the plates
/// were off the plan on the way.
///
/// A value: a copy goes on as this one would.
class PlanFollower {
 public:
  PlanFollower(const ArmDescription& arm, const MotionModel& model)
      : feedback_(arm, model.no_load(), model.valves()),
        off_plan_(Backbone::Zero(arm.point_count(), kPoseSize)) {}

  /// Another plan begins.
  void forget();
  /// The arm came to `shape` in a frame in which its plan has it at `planned`.
  void learn(const Backbone& planned, const Backbone& shape);
  /// The plan has ended, and the tip is led to the goal.
  void learn_from_goal(const PoseGoal& goal, const Backbone& shape) {
    feedback_.learn_from_goal(goal, shape);
  }
  /// ShapeFeedback::setpoint
  Pressures setpoint(const Pressures& planned_kpa, const Pressures& before_kpa,
                     const std::vector<PressureLimits>& limits) {
    return feedback_.setpoint(planned_kpa, before_kpa, limits);
  }

  /// Where the arm is beside where its plan has it: its shape less the plan's.
  const Backbone& off_plan() const { return off_plan_; }
  /// The farthest that a plate is off. [m]
  double farthest_m() const { return farthest_m_; }

 private:
  ShapeFeedback feedback_;
  Backbone off_plan_;  // in the frame that was learnt last; none: zero
  double farthest_m_ = 0.0;
};

}  // namespace limber
