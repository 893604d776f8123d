#include "limber/run/jacobian_controller.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limber/arm/damped_solve.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/run/executor.hpp"

namespace limber {

namespace {

constexpr double kSlopeStepKpa = 1.0;  // of the central difference
constexpr double kAfterPlanS = 10.0;
constexpr double kSettledM = 0.001;
constexpr double kSettledS = 1.0;

}  // namespace

JacobianController::JacobianController(const ArmDescription& arm, const Plan& plan,
                                       const PoseGoal& goal, const JacobianGains& gains)
    : arm_(with_limits(arm, plan.limits)),
      model_(arm),
      plan_(plan),
      goal_(goal),
      gains_(gains),
      rows_(goal.theta_rad ? kPoseSize : 2),
      setpoint_kpa_(plan.frames.front().setpoint_kpa) {
  if (goal_.theta_rad) {  // by the turns that the tip makes, not by whole ones more
    const double end_rad = tip_pose(plan.frames.back().backbone).theta_rad;
    *goal_.theta_rad = end_rad + std::remainder(*goal_.theta_rad - end_rad, 2.0 * std::numbers::pi);
  }
}

/// x, y and, if the goal asks for one, the heading as a length.
Eigen::VectorXd JacobianController::in_metres(const Pose& pose) const {
  Eigen::VectorXd result(rows_);
  result[0] = pose.x_m;
  result[1] = pose.y_m;
  if (rows_ == kPoseSize) {
    result[2] = pose.theta_rad * goal_.position_tolerance_m / goal_.orientation_tolerance_rad;
  }
  return result;
}

Eigen::VectorXd JacobianController::predicted(std::size_t frame) const {
  return in_metres(tip_pose(plan_.frames[frame].backbone));
}

Eigen::VectorXd JacobianController::reference(std::size_t frame) const {
  return frame < plan_.frames.size()
             ? predicted(frame)
             : in_metres({goal_.x_m, goal_.y_m, goal_.theta_rad.value_or(0.0)});
}

Eigen::MatrixXd JacobianController::no_load_jacobian() const {
  const Eigen::VectorXd at = setpoint_kpa_.cast<double>();
  Eigen::MatrixXd jacobian(rows_, at.size());
  BackboneD backbone(model_.point_count(), kPoseSize);
  const auto tip_at = [&](const Eigen::VectorXd& kpa) {
    model_.backbone(Eigen::Ref<const Eigen::VectorXd>(kpa), Eigen::Ref<BackboneD>(backbone));
    return in_metres(tip_pose(backbone));
  };
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const Eigen::VectorXd step = kSlopeStepKpa * Eigen::VectorXd::Unit(at.size(), i);
    jacobian.col(i) = (tip_at(at + step) - tip_at(at - step)) / (2.0 * kSlopeStepKpa);
  }
  return jacobian;
}

Eigen::VectorXd JacobianController::correction(const Eigen::VectorXd& velocity) const {
  const double lambda = gains_.damping_m_per_kpa;
  const Eigen::MatrixXd jacobian = no_load_jacobian();
  return jacobian.transpose() *
         damped_solve(jacobian * jacobian.transpose(), velocity, lambda * lambda);
}

bool JacobianController::has_ended(const std::optional<Eigen::VectorXd>& error) {
  if (frame_ < plan_.frames.size()) {
    return false;
  }
  const auto after = int(frame_ + 1 - plan_.frames.size());
  settled_ = error && error->norm() < kSettledM ? settled_ + 1 : 0;
  return settled_ >= arm_.frames_in(kSettledS) || after >= arm_.frames_in(kAfterPlanS);
}

/// What the tip is to move in this frame: PI in velocity form. @param seen  frame that `tip` shows
Eigen::VectorXd JacobianController::feedback(const Eigen::VectorXd& tip, std::size_t seen) const {
  Eigen::VectorXd velocity =
      gains_.integral_per_s * arm_.frame_period_s() * (reference(seen) - tip);
  if (!tip_before_) {
    return velocity;
  }
  velocity -= gains_.proportional * (tip - *tip_before_);
  if (seen > 0 && seen < plan_.frames.size()) {
    velocity += gains_.proportional * (predicted(seen) - predicted(seen - 1));
  }
  return velocity;
}

Decision JacobianController::step(const Moment& now) {
  // What is measured belongs to an older frame where states are late; what is commanded, to the one
  // after frame_.
  const std::size_t seen = frame_ - std::min(frame_, std::size_t(now.arm.lag_frames()));
  std::optional<Eigen::VectorXd> error;
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(rows_);
  if (const std::optional<Backbone>& shape = now.arm.measured().backbone;
      shape && now.arm.frames_unseen() == 0) {
    const Eigen::VectorXd tip = in_metres(tip_pose(*shape));
    error = reference(seen) - tip;
    velocity = feedback(tip, seen);
    tip_before_ = tip;
  } else {
    tip_before_.reset();
  }
  if (has_ended(error)) {
    return {};
  }
  Eigen::VectorXd wanted = setpoint_kpa_.cast<double>() + correction(velocity);
  if (frame_ + 1 < plan_.frames.size()) {
    wanted +=
        (plan_.frames[frame_ + 1].setpoint_kpa - plan_.frames[frame_].setpoint_kpa).cast<double>();
  }
  setpoint_kpa_ = within_frame_rule(arm_, setpoint_kpa_, wanted);
  ++frame_;
  const Plan* plan = frame_ < plan_.frames.size() ? &plan_ : nullptr;
  return {.setpoint_kpa = setpoint_kpa_, .plan = plan, .frame = frame_};
}

}  // namespace limber
