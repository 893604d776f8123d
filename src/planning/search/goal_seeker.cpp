#include "goal_seeker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limber/arm/damped_solve.hpp"
#include "limber/arm/jacobian.hpp"
#include "limber/world/pressure_box.hpp"

namespace limber {

namespace {

constexpr double kNewtonToleranceM = 1e-3;  // of an inverse-kinematics solution
constexpr double kNewtonToleranceRad = 0.01;
constexpr double kLimitsPerTolerance = 20.0;  // of the largest command, for merits
constexpr double kStepDamping = 1e-3;         // of the step's normal matrix, of its trace

}  // namespace

double goal_error(const PoseGoal& goal, const Pose& tip) {
  const PoseError error = pose_error(goal, tip);
  return error.position_m / goal.position_tolerance_m +
         (goal.theta_rad ? error.orientation_rad / goal.orientation_tolerance_rad : 0.0);
}

bool HoldRange::reaches(const PoseGoal& goal, const Pose& settled_tip) const {
  const PoseError error = pose_error(goal, settled_tip);
  return error.position_m <= goal.position_tolerance_m + position_m &&
         error.orientation_rad <= goal.orientation_tolerance_rad + orientation_rad;
}

GoalAim::GoalAim(const PlanningProblem& problem)
    : goal_(problem.environment.goal),
      inner_(problem.environment.goal),
      kpa_per_tolerance_(kLimitsPerTolerance *
                         double(pressure_limits_kpa(problem.arm).maxCoeff())) {
  if (problem.aim) {
    inner_.position_tolerance_m = std::min(goal_.position_tolerance_m, problem.aim->position_m);
    inner_.orientation_tolerance_rad =
        std::min(goal_.orientation_tolerance_rad, problem.aim->orientation_rad);
  }
}

double GoalAim::beyond(const Pose& held_tip) const {
  const PoseError error = pose_error(goal_, held_tip);
  const double turn =
      goal_.theta_rad ? std::max(0.0, error.orientation_rad - inner_.orientation_tolerance_rad) /
                            goal_.orientation_tolerance_rad
                      : 0.0;
  return std::max(0.0, error.position_m - inner_.position_tolerance_m) /
             goal_.position_tolerance_m +
         turn;
}

const Pressures& GoalSampler::sample(RandomStream& random) {
  if (int(sampled_kpa_.size()) >= count_) {
    return sampled_kpa_[random.index(std::uint32_t(sampled_kpa_.size()))];
  }
  // A pose of the region: uniform in the disc, and in the interval of headings.
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double radius = goal_.position_tolerance_m * std::sqrt(random.uniform());
  PoseGoal target = goal_;
  target.x_m += radius * std::cos(angle);
  target.y_m += radius * std::sin(angle);
  target.position_tolerance_m = std::min(kNewtonToleranceM, goal_.position_tolerance_m);
  if (goal_.theta_rad) {
    *target.theta_rad += random.uniform(-1.0, 1.0) * goal_.orientation_tolerance_rad;
    target.orientation_tolerance_rad =
        std::min(kNewtonToleranceRad, goal_.orientation_tolerance_rad);
  }
  InverseKinematicsSettings settings;
  settings.starts = 4;
  settings.max_solutions = 1;
  settings.convergence_m = 0.1 * kNewtonToleranceM;
  settings.limits = limits_;
  const InverseKinematicsResult found = solve_inverse_kinematics(model_, target, settings, random);
  sampled_kpa_.emplace_back(
      (found.reachable() ? found.pressures_kpa.front() : found.best_pressures_kpa).cast<float>());
  return sampled_kpa_.back();
}

Pressures step_toward_goal(const NoLoadModel& model, const PoseGoal& goal, double arm_length_m,
                           const Eigen::Ref<const Pressures>& from_kpa, const Pose& tip) {
  SegmentVector curvatures(from_kpa.size());
  for (int i = 0; i < from_kpa.size(); ++i) {
    curvatures[i] = model.segment_shape(i, double(from_kpa[i])).curvature_per_m;
  }
  PlanarJacobian jacobian;
  Pose no_load_tip;
  tip_jacobian(model, curvatures, jacobian, no_load_tip);
  Eigen::Vector3d error(goal.x_m - tip.x_m, goal.y_m - tip.y_m, 0.0);
  if (goal.theta_rad) {
    error.z() =
        arm_length_m * std::remainder(*goal.theta_rad - tip.theta_rad, 2.0 * std::numbers::pi);
  }
  jacobian.row(2) *= goal.theta_rad ? arm_length_m : 0.0;
  const Eigen::Matrix3d normal = jacobian * jacobian.transpose();
  curvatures += jacobian.transpose() * damped_solve(normal, error, kStepDamping * normal.trace());
  Pressures to_kpa(from_kpa.size());
  for (int i = 0; i < to_kpa.size(); ++i) {
    to_kpa[i] = float(model.pressure_for_curvature(i, curvatures[i]).pressure_kpa);
  }
  return to_kpa;
}

}  // namespace limber
