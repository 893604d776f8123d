#include "shape_feedback.hpp"

#include <cmath>

#include "limber/arm/pressure_limits.hpp"
#include "limber/run/executor.hpp"

namespace limber {

namespace {

// Of an arm that has gone less than half the way to new set points after a frame.
constexpr double kSlowProportional = 1.5;
constexpr double kSlowIntegralPerS = 8.0;
// Of others: g (2 K_p + K_i Δt) < 2 keeps an arm from swinging that bends g times as far as
// modelled.
constexpr double kProportional = 0.2;
constexpr double kIntegralPerS = 4.0;
constexpr double kLeastBendRad = 0.1;  // between its limits: less is no bending

double turn_rad(const NoLoadModel& model, int segment, double kpa) {
  const SegmentShape shape = model.segment_shape(segment, kpa);
  return shape.curvature_per_m * shape.length_m;
}

/// Whether all pressures are less than half the way to new set points after a frame, of the largest
/// change that a frame allows: valves with a dead band don't follow small ones at all.
bool is_slow(const ArmDescription& arm, const ValveModel& valves) {
  const Eigen::Index n = valves.segment_count();
  const auto step_kpa = float(arm.pressure_step_limit_kpa());
  Eigen::VectorXf state = valves.settled_state(Pressures::Zero(n));
  valves.step(Pressures::Constant(n, step_kpa), state);
  return state.head(n).maxCoeff() < 0.5F * step_kpa;
}

}  // namespace

ShapeFeedback::ShapeFeedback(const ArmDescription& arm, const NoLoadModel& model,
                             const ValveModel& valves)
    : limits_(limits_of(arm)),
      plates_{0},
      kpa_per_rad_(Eigen::VectorXd::Zero(arm.segment_count())),
      proportional_(is_slow(arm, valves) ? kSlowProportional : kProportional),
      integral_per_s_(is_slow(arm, valves) ? kSlowIntegralPerS : kIntegralPerS),
      step_limit_kpa_(arm.pressure_step_limit_kpa()),
      frame_period_s_(arm.frame_period_s()),
      off_plan_(Backbone::Zero(arm.point_count(), kPoseSize)) {
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& segment = arm.segments[i];
    const PressureLimits& limits = segment.pressure_limit_kpa;
    plates_.push_back(plates_.back() + segment.gaps);
    const double bend_rad =
        turn_rad(model, i, limits.upper_kpa) - turn_rad(model, i, limits.lower_kpa);
    if (std::abs(bend_rad) >= kLeastBendRad) {
      kpa_per_rad_[i] = (limits.upper_kpa - limits.lower_kpa) / bend_rad;
    }
  }
  forget();
}

void ShapeFeedback::forget() {
  trim_kpa_ = Eigen::VectorXd::Zero(kpa_per_rad_.size());
  missed_rad_.resize(0);
  off_plan_.setZero();
}

Eigen::VectorXd ShapeFeedback::bends_rad(const Backbone& backbone) const {
  Eigen::VectorXd bends(kpa_per_rad_.size());
  for (Eigen::Index i = 0; i < bends.size(); ++i) {
    bends[i] = double(backbone(plates_[i + 1], 2)) - double(backbone(plates_[i], 2));
  }
  return bends;
}

void ShapeFeedback::learn(const Backbone& planned, const Backbone& shape) {
  off_plan_ = shape - planned;
  const Eigen::VectorXd missed_rad = bends_rad(planned) - bends_rad(shape);
  Eigen::VectorXd more_rad = integral_per_s_ * frame_period_s_ * missed_rad;
  if (missed_rad_.size() > 0) {
    more_rad += proportional_ * (missed_rad - missed_rad_);
  }
  trim_kpa_ += kpa_per_rad_.cwiseProduct(more_rad);
  missed_rad_ = missed_rad;
}

Pressures ShapeFeedback::setpoint(const Pressures& planned_kpa, const Pressures& before_kpa,
                                  const std::vector<PressureLimits>& limits) {
  const Eigen::VectorXd planned = planned_kpa.cast<double>();
  const Pressures sent = within_frame_rule(limits.empty() ? limits_ : limits, step_limit_kpa_,
                                           before_kpa, planned + trim_kpa_);
  trim_kpa_ = sent.cast<double>() - planned;
  return sent;
}

}  // namespace limber
