#include "arm_estimate.hpp"

#include <utility>

#include "limber/arm/plate_distance.hpp"

namespace limber {

ArmStart start_at(const MotionState& state) {
  ArmStart start{state.pressure_kpa(), state.backbone};
  const Eigen::Index n = state.segments;
  for (Eigen::Index at = n; at + n <= state.valves.size(); at += n) {
    start.setpoints_kpa.emplace_back(state.valves.segment(at, n));
  }
  start.before = state.before;
  return start;
}

void ArmEstimate::observe(const Pressures& setpoint_kpa, const ArmState& measured) {
  const int said = lag_.note(setpoint_kpa, measured);
  const int found = pressure_lag_.note(setpoint_kpa, measured.pressure_kpa);
  const auto lag = static_cast<std::size_t>(measured.setpoint_kpa ? said : found);
  bool is_later = true;
  if (valves_.size() == 0) {
    valves_ = model_.valves().settled_state(setpoint_kpa);
  } else {
    coming_kpa_.push_back(setpoint_kpa);
    is_later = coming_kpa_.size() > lag;
    while (coming_kpa_.size() > lag) {
      take_next(measured.pressure_kpa);
    }
  }
  if (!measured.backbone) {
    ++frames_unseen_;
  } else {
    if (state_ && is_later) {
      note_miss(*measured.backbone);
    }
    // What it had a frame ago was corrected then, and has been kept by the prediction since.
    const Backbone before = state_ ? state_->before : *measured.backbone;
    const Backbone* predicted = state_ ? &state_->backbone : start_ ? &*start_ : nullptr;
    const Backbone now = filter_ && predicted != nullptr
                             ? filter_->corrected(*predicted, *measured.backbone)
                             : *measured.backbone;
    state_ = model_.moving_state(valves_, now, state_ ? before : now);
    frames_unseen_ = 0;
    if (is_later) {
      check_.compare(*state_);
      miss_.plate_m = check_.missed_m();
    }
  }
  look_ahead();
}

/// The frame of the set points that are next. @param pressure_kpa  measured in it
void ArmEstimate::take_next(const Pressures& pressure_kpa) {
  const Pressures& setpoint_kpa = coming_kpa_.front();
  const Eigen::Index n = setpoint_kpa.size();
  miss_.travelled_kpa += double((setpoint_kpa - valves_.segment(n, n)).cwiseAbs().sum());
  predict(setpoint_kpa, pressure_kpa);
  coming_kpa_.pop_front();
}

void ArmEstimate::look_ahead() {
  const std::optional<MotionState> before = std::exchange(ahead_, state_);
  if (ahead_) {
    for (const Pressures& setpoint_kpa : coming_kpa_) {
      model_.step(setpoint_kpa, *ahead_, workspace_);
    }
    moved_m_ = before ? largest_plate_distance_m(before->backbone, ahead_->backbone) : 0.0;
  }
}

void ArmEstimate::predict(const Pressures& setpoint_kpa, const Pressures& pressure_kpa) {
  const Eigen::Index n = setpoint_kpa.size();
  const Pressures before_kpa = valves_.head(n);
  model_.valves().step(setpoint_kpa, valves_);
  if (!model_.valves().is_ideal()) {
    valves_.head(n) = pressure_kpa;
  }
  if (filter_) {
    filter_->predict();
  }
  check_.step(model_, before_kpa, valves_.head(n), workspace_);
  if (state_) {
    model_.step_shape(before_kpa, valves_.head(n), state_->before, state_->backbone, workspace_);
    state_->valves = valves_;
  }
}

void ArmEstimate::note_miss(const Backbone& measured) {
  const Pose expected = tip_pose(state_->backbone);
  const Pose found = tip_pose(measured);
  miss_.latest = {found.x_m - expected.x_m, found.y_m - expected.y_m,
                  found.theta_rad - expected.theta_rad};
  miss_.sum += miss_.latest;
}

}  // namespace limber
