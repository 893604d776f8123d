#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "checked_plans.hpp"
#include "limber/run/plan_controller.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// What a radian of heading counts as, where the heading counts as much as the position if each is
/// at its tolerance; 0 where the goal asks for no heading. [m/rad]
double m_per_rad(const PoseGoal& goal);
/// Both errors of a pose as one length.
double as_length_m(const PoseGoal& goal, const PoseError& error);
/// From a tip to the goal's centre: x, y and the heading as a length. [m]
Eigen::Vector3d missing_m(const PoseGoal& goal, const Pose& tip);

/// What a model is asked for to end in `goal`, if its tip misses by that much (x, y, heading).
PoseGoal asked_goal(PoseGoal goal, const Eigen::Vector3d& miss);

/// What is left of a plan for an arm in motion: the set points of its next frame, then the plan's
/// waypoints after that frame, its end last.
std::vector<Pressures> waypoints_after(const PlanProgress& at, double step_limit_kpa);

/// Shifts the end of what is left of a plan, and the waypoints before it in proportion to how far
/// along they are, so that the tip comes to rest nearer to the goal's centre. The model itself says
/// what a shift does (finite differences, one rollout per segment), then a few damped Newton steps
/// are taken, each simulated. The nearest of them that is free is the repair.
///
/// Borrows what makes plans. Threads: as that.
class PlanRepair {
 public:
  explicit PlanRepair(CheckedPlans& plans) : plans_(plans), box_(setpoints_of(plans.problem())) {}

  /// @return waypoints, the first one kept; none if nothing free ends nearer than `max_error_m`
  std::optional<std::vector<Pressures>> toward_goal(const std::vector<Pressures>& waypoints_kpa,
                                                    double max_error_m);

 private:
  /// Columns: what one kPa at the end of each segment does to the settled tip (x, y, heading).
  Eigen::MatrixXd sensitivity(const std::vector<Pressures>& waypoints_kpa);
  std::vector<Pressures> shifted(std::vector<Pressures> waypoints_kpa,
                                 const Eigen::VectorXd& shift_kpa) const;

  CheckedPlans& plans_;
  PressureBox box_;  // set points stay in there
};

/// A checked plan from the problem's start along these waypoints, their end shifted so that the tip
/// comes to rest as near to the problem's goal as it can (PlanRepair).
/// @param max_error_m  none if it ends no nearer (as_length_m)
std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check);

}  // namespace limber
