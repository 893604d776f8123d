#include "plan_repair.hpp"

#include <cmath>
#include <numbers>

#include "limber/arm/damped_solve.hpp"

namespace limber {

namespace {

constexpr double kProbeShare = 0.02;     // of a segment's range: what sensitivities are taken from
constexpr double kRepairDamping = 1e-3;  // of the normal matrix, of its mean diagonal
constexpr int kRepairSteps = 4;

/// What a radian of heading counts as; 0 where the goal asks for no heading. [m/rad]
double m_per_rad(const PoseGoal& goal) {
  return goal.theta_rad ? goal.position_tolerance_m / goal.orientation_tolerance_rad : 0.0;
}

/// From a tip to the goal's centre: x, y and the heading as a length. [m]
Eigen::Vector3d missing_m(const PoseGoal& goal, const Pose& tip) {
  const double turn = goal.theta_rad
                          ? std::remainder(*goal.theta_rad - tip.theta_rad, 2.0 * std::numbers::pi)
                          : 0.0;
  return {goal.x_m - tip.x_m, goal.y_m - tip.y_m, m_per_rad(goal) * turn};
}

std::vector<Pressures> shifted(const PressureBox& box, std::vector<Pressures> waypoints_kpa,
                               const Eigen::VectorXd& shift_kpa) {
  const double whole = path_cost_kpa(waypoints_kpa);
  double gone = 0.0;
  Pressures before = waypoints_kpa.front();
  for (std::size_t w = 1; w < waypoints_kpa.size(); ++w) {
    gone += motion_cost_kpa(before, waypoints_kpa[w]);
    before = waypoints_kpa[w];
    const bool is_end = w + 1 == waypoints_kpa.size();
    const double share = is_end || whole <= 0.0 ? 1.0 : gone / whole;
    waypoints_kpa[w] = box.limited(waypoints_kpa[w] + (share * shift_kpa).cast<float>());
  }
  return waypoints_kpa;
}

/// Columns: what one kPa at the end of each segment does to the settled tip (x, y, heading); zero
/// of a segment whose limits leave it nothing.
Eigen::MatrixXd sensitivity(CheckedPlans& plans, const PressureBox& box,
                            const std::vector<Pressures>& waypoints_kpa) {
  const Eigen::Index n = waypoints_kpa.front().size();
  const Pressures range_kpa = box.high_kpa - box.low_kpa;
  std::vector<std::vector<Pressures>> paths{waypoints_kpa};
  Eigen::VectorXd probes(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool has_room =
        waypoints_kpa.back()[i] + float(kProbeShare) * range_kpa[i] <= box.high_kpa[i];
    probes[i] = (has_room ? kProbeShare : -kProbeShare) * double(range_kpa[i]);
    paths.push_back(shifted(box, waypoints_kpa, probes[i] * Eigen::VectorXd::Unit(n, i)));
  }
  MotionBatch batch(plans.simulator());
  std::vector<MotionState> at(paths.size(), plans.from());
  Eigen::MatrixXf to(n, Eigen::Index(paths.size()));
  for (std::size_t w = 1; w < waypoints_kpa.size(); ++w) {
    for (std::size_t j = 0; j < paths.size(); ++j) {
      to.col(Eigen::Index(j)) = paths[j][w];
    }
    batch.run(at, to);
    for (std::size_t j = 0; j < paths.size(); ++j) {
      at[j] = batch.end(int(j));
    }
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(kPoseSize, n);
  const auto settled = [&](std::size_t j) {
    return numbers_of(plans.problem().model.settled_tip(at[j].valves, at[j].backbone));
  };
  const Eigen::Vector3d middle = settled(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (probes[i] != 0.0) {
      result.col(i) = (settled(std::size_t(i) + 1) - middle) / probes[i];
    }
  }
  return result;
}

std::optional<std::vector<Pressures>> shifted_toward_goal(
    CheckedPlans& plans, const std::vector<Pressures>& waypoints_kpa, double max_error_m) {
  const PoseGoal& goal = plans.problem().environment.goal;
  const PressureBox box = setpoints_of(plans.problem());
  Eigen::MatrixXd jacobian = sensitivity(plans, box, waypoints_kpa);
  jacobian.row(2) *= m_per_rad(goal);
  const Eigen::Matrix3d normal = jacobian * jacobian.transpose();
  const double damping = kRepairDamping * normal.trace() / kPoseSize;
  std::optional<std::vector<Pressures>> best;
  Eigen::VectorXd shift_kpa = Eigen::VectorXd::Zero(waypoints_kpa.front().size());
  std::vector<Pressures> tried = waypoints_kpa;
  for (int step = 0; step <= kRepairSteps; ++step) {
    const std::optional<MotionState> end = plans.end_of(tried);
    if (!end) {
      break;
    }
    const Pose tip = tip_pose(end->backbone);
    const double error_m = as_length_m(goal, pose_error(goal, tip));
    if (error_m < max_error_m) {
      max_error_m = error_m;
      best = tried;
    }
    shift_kpa += jacobian.transpose() * damped_solve(normal, missing_m(goal, tip), damping);
    tried = shifted(box, waypoints_kpa, shift_kpa);
  }
  return best;
}

}  // namespace

double as_length_m(const PoseGoal& goal, const PoseError& error) {
  return std::hypot(error.position_m, m_per_rad(goal) * error.orientation_rad);
}

PoseGoal asked_goal(PoseGoal goal, const Eigen::Vector3d& miss) {
  goal.x_m -= miss.x();
  goal.y_m -= miss.y();
  if (goal.theta_rad) {
    *goal.theta_rad -= miss.z();
  }
  return goal;
}

std::vector<Pressures> waypoints_after(const PlanProgress& at, double step_limit_kpa) {
  const Plan& plan = at.plan;
  std::vector<Pressures> rest{at.sent_kpa};
  std::size_t reached = 0;  // the frame in which the plan is at waypoint w
  for (std::size_t w = 1; w < plan.waypoints_kpa.size(); ++w) {
    reached += std::size_t(
        motion_frame_count(plan.waypoints_kpa[w - 1], plan.waypoints_kpa[w], step_limit_kpa));
    if (reached > at.frame) {
      rest.push_back(plan.waypoints_kpa[w]);
    }
  }
  if (rest.size() == 1) {
    rest.push_back(rest.front());  // it holds: a motion to where it is
  }
  return rest;
}

std::optional<Plan> repaired_plan(const PlanningProblem& problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check) {
  CheckedPlans plans(problem, check);
  const std::optional<std::vector<Pressures>> shifted_kpa =
      shifted_toward_goal(plans, waypoints_kpa, max_error_m);
  return shifted_kpa ? plans.checked(*shifted_kpa, "repair", seed) : std::nullopt;
}

}  // namespace limber
