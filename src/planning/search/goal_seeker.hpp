#pragma once

#include <utility>
#include <vector>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/inverse_kinematics.hpp"

namespace limber {

/// Distance to the goal in tolerances, for comparing states.
double goal_error(const PoseGoal& goal, const Pose& tip);

/// How near the goal a motion's tip has to settle (MotionModel::settled_tip) for the hold after it
/// to be worth simulating.
struct HoldRange {
  double position_m = 0.05;
  double orientation_rad = 0.5;

  bool reaches(const PoseGoal& goal, const Pose& settled_tip) const;
};

/// Where in the goal a plan should end: arriving well comes before a low cost.
class GoalAim {
 public:
  explicit GoalAim(const PlanningProblem& problem);

  /// The goal with the aim's tolerances.
  const PoseGoal& inner() const { return inner_; }
  /// How far a tip in the goal is beyond the aim, in the goal's tolerances; 0 within it.
  double beyond(const Pose& held_tip) const;
  /// The number that plans are compared by: their cost, plus much more if they end beyond the aim.
  double merit_kpa(double cost_kpa, const Pose& held_tip) const {
    return cost_kpa + kpa_per_tolerance_ * beyond(held_tip);
  }

 private:
  PoseGoal goal_;
  PoseGoal inner_;
  double kpa_per_tolerance_;  // several times what plans cost
};

/// Configurations whose no-load tip lies in the goal's region, sampled one by one (the paper's goal
/// biasing); where the no-load model does not reach it, the nearest configurations found.
class GoalSampler {
 public:
  /// @param limits  that the configurations keep; empty: the model's
  GoalSampler(const NoLoadModel& model, const PoseGoal& goal, int count,
              std::vector<PressureLimits> limits = {})
      : model_(model), goal_(goal), count_(count), limits_(std::move(limits)) {}

  const Pressures& sample(RandomStream& random);
  /// How many are sampled before they are used again; each takes a good part of a millisecond.
  void draw_at_most(int count) { count_ = count; }

 private:
  const NoLoadModel& model_;
  const PoseGoal& goal_;
  int count_;
  std::vector<PressureLimits> limits_;
  std::vector<Pressures> sampled_kpa_;
};

/// The Newton step of the no-load model from `from_kpa` that would take the tip, which another
/// model has at `tip`, to the goal: J⁺ of the error that remains, damped (resolved rate). The
/// pressures are not limited.
/// @param arm_length_m  weighs a turn against a distance
Pressures step_toward_goal(const NoLoadModel& model, const PoseGoal& goal, double arm_length_m,
                           const Eigen::Ref<const Pressures>& from_kpa, const Pose& tip);

}  // namespace limber
