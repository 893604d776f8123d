#include "limber/run/jacobian_controller.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace limber {

namespace {

constexpr double kSlopeStepKpa = 1.0;    // of the central difference
constexpr double kUpdateWindowS = 0.25;  // Broyden's Δy and Δp are taken over it
constexpr double kMinMotionKpa = 0.5;    // |Δp| below which nothing is learnt
constexpr double kMaxGrowth = 10.0;      // of a learnt Jacobian's norm over the first one's
constexpr double kAfterPlanS = 10.0;
constexpr double kSettledM = 0.001;
constexpr double kSettledS = 1.0;

/// Within the plan's limits, too.
ArmDescription narrowed(ArmDescription arm, const std::vector<PressureLimits>& limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    arm.segments[i].pressure_limit_kpa = arm.segments[i].pressure_limit_kpa.within(limits[i]);
  }
  return arm;
}

}  // namespace

JacobianController::JacobianController(const ArmDescription& arm, const Plan& plan,
                                       const PoseGoal& goal, const JacobianGains& gains)
    : arm_(narrowed(arm, plan.limits)),
      model_(arm),
      plan_(plan),
      goal_(goal),
      gains_(gains),
      rows_(goal.theta_rad ? 3 : 2),
      setpoint_kpa_(plan.frames.front().setpoint_kpa),
      jacobian_(no_load_jacobian()),
      largest_norm_(kMaxGrowth * jacobian_.norm()) {}

/// x, y and, if the goal asks for one, the heading as a length.
Eigen::VectorXd JacobianController::in_metres(const Pose& pose) const {
  Eigen::VectorXd result(rows_);
  result[0] = pose.x_m;
  result[1] = pose.y_m;
  if (rows_ == 3) {
    result[2] = pose.theta_rad * goal_.position_tolerance_m / goal_.orientation_tolerance_rad;
  }
  return result;
}

Eigen::VectorXd JacobianController::predicted(std::size_t frame) const {
  return in_metres(tip_pose<float>(plan_.frames[frame].backbone));
}

Eigen::VectorXd JacobianController::reference() const {
  return frame_ < plan_.frames.size()
             ? predicted(frame_)
             : in_metres({goal_.x_m, goal_.y_m, goal_.theta_rad.value_or(0.0)});
}

Eigen::MatrixXd JacobianController::no_load_jacobian() const {
  const Eigen::VectorXd at = setpoint_kpa_.cast<double>();
  Eigen::MatrixXd jacobian(rows_, at.size());
  BackboneD backbone(model_.point_count(), 3);
  const auto tip_at = [&](const Eigen::VectorXd& kpa) {
    model_.backbone(Eigen::Ref<const Eigen::VectorXd>(kpa), Eigen::Ref<BackboneD>(backbone));
    const auto tip = backbone.bottomRows<1>();
    return in_metres({tip(0, 0), tip(0, 1), tip(0, 2)});
  };
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const Eigen::VectorXd step = kSlopeStepKpa * Eigen::VectorXd::Unit(at.size(), i);
    jacobian.col(i) = (tip_at(at + step) - tip_at(at - step)) / (2.0 * kSlopeStepKpa);
  }
  return jacobian;
}

void JacobianController::learn(const Seen& now) {
  const auto window = static_cast<std::size_t>(arm_.frames_in(kUpdateWindowS));
  if (seen_.size() < window) {
    return;
  }
  const Seen& then = seen_[seen_.size() - window];
  const Eigen::VectorXd moved_kpa = now.pressure_kpa - then.pressure_kpa;
  const double square = moved_kpa.squaredNorm();
  if (square < kMinMotionKpa * kMinMotionKpa) {
    return;
  }
  const Eigen::VectorXd missed = now.tip - then.tip - jacobian_ * moved_kpa;
  jacobian_ += gains_.update / square * missed * moved_kpa.transpose();
  const double norm = jacobian_.norm();
  if (norm > largest_norm_) {
    jacobian_ *= largest_norm_ / norm;
  }
}

Eigen::VectorXd JacobianController::correction(const Eigen::VectorXd& velocity) const {
  const double lambda = gains_.damping_m_per_kpa;
  const Eigen::MatrixXd square =
      jacobian_ * jacobian_.transpose() + lambda * lambda * Eigen::MatrixXd::Identity(rows_, rows_);
  return jacobian_.transpose() * square.ldlt().solve(velocity);
}

bool JacobianController::has_ended(const std::optional<Eigen::VectorXd>& error) {
  if (frame_ < plan_.frames.size()) {
    return false;
  }
  const auto after = static_cast<int>(frame_ + 1 - plan_.frames.size());
  settled_ = error && error->norm() < kSettledM ? settled_ + 1 : 0;
  return settled_ >= arm_.frames_in(kSettledS) || after >= arm_.frames_in(kAfterPlanS);
}

/// What the tip is to move in this frame: PI in velocity form.
Eigen::VectorXd JacobianController::feedback(const Seen& now, const Eigen::VectorXd& error) const {
  Eigen::VectorXd velocity = gains_.integral_per_s * arm_.frame_period_s() * error;
  if (seen_.empty()) {
    return velocity;
  }
  velocity -= gains_.proportional * (now.tip - seen_.back().tip);
  if (frame_ > 0 && frame_ < plan_.frames.size()) {
    velocity += gains_.proportional * (predicted(frame_) - predicted(frame_ - 1));
  }
  return velocity;
}

void JacobianController::remember(const Seen& now) {
  if (gains_.update > 0.0) {
    learn(now);
  } else {
    jacobian_ = no_load_jacobian();
  }
  seen_.push_back(now);
  if (static_cast<int>(seen_.size()) > arm_.frames_in(kUpdateWindowS)) {
    seen_.pop_front();
  }
}

std::optional<Pressures> JacobianController::next(const ArmState& state) {
  // What is measured belongs to plan frame `frame_`; what is commanded, to the one after it.
  std::optional<Eigen::VectorXd> error;
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(rows_);
  if (state.backbone) {
    const Seen now{in_metres(tip_pose<float>(*state.backbone)), state.pressure_kpa.cast<double>()};
    error = reference() - now.tip;
    velocity = feedback(now, *error);
    remember(now);
  } else {
    seen_.clear();
  }
  if (has_ended(error)) {
    return std::nullopt;
  }
  Eigen::VectorXd wanted = setpoint_kpa_.cast<double>() + correction(velocity);
  if (frame_ + 1 < plan_.frames.size()) {
    wanted +=
        (plan_.frames[frame_ + 1].setpoint_kpa - plan_.frames[frame_].setpoint_kpa).cast<double>();
  }
  setpoint_kpa_ = within_frame_rule(arm_, setpoint_kpa_, wanted);
  ++frame_;
  return setpoint_kpa_;
}

}  // namespace limber
