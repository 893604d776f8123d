#include "limber/run/safety_gate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kStuckWindowS = 1.0;  // a reading that stands still for so long …
constexpr double kStuckDelayS = 0.5;   // … though the set point had moved so long before
constexpr double kStuckShare = 0.02;   // of the set point's change: less is none
// At low rates: a state may be of the frame before, and a channel has to have one more to move in.
constexpr int kMinFollowingFrames = 3;
constexpr int kMinStuckFrames = 4;
constexpr int kMinStuckDelayFrames = 2;

int stuck_frames(const ArmDescription& arm) {
  return std::max(arm.frames_in(kStuckWindowS), kMinStuckFrames);
}

double rounding_kpa(const ArmDescription& arm, int channel) {
  return kSetpointRoundingShare * arm.limits_of_channel(channel).largest_kpa();
}

/// Of the side that `kpa` is on; without a sign where both have the same.
double limit_of(const PressureLimits& limits, double kpa) {
  return limits.is_symmetric() ? limits.upper_kpa : limits.side_kpa(kpa);
}

bool is_within(const Fence& fence, const Eigen::RowVector3d& position) {
  const auto between = [](double low, double value, double high) {
    return value >= low && value <= high;  // no NaN is
  };
  return between(fence.x_min_m, position.x(), fence.x_max_m) &&
         between(fence.y_min_m, position.y(), fence.y_max_m) &&
         between(fence.z_min_m, position.z(), fence.z_max_m);
}

/// Where a shape can't be the arm's: it is in another unit, or of markers in another order.
std::string another_scale(const PlatePositions& shape, double arm_length_m) {
  constexpr double kMaxFactor = 1.5;  // what strains and chords make of a length
  const Eigen::Index gaps = shape.rows() - 1;
  const double length_m = (shape.bottomRows(gaps) - shape.topRows(gaps)).rowwise().norm().sum();
  if (length_m < kMaxFactor * arm_length_m && kMaxFactor * length_m > arm_length_m) {
    return "";
  }
  return fmt::format(". The shape is {:.3g} m long from plate to plate, and the arm {:.3g} m",
                     length_m, arm_length_m);
}

}  // namespace

bool allow(const PressureLimits& limits, double kpa, double rounding_kpa) {
  return kpa >= limits.lower_kpa - rounding_kpa &&
         kpa <= limits.upper_kpa + rounding_kpa;  // no NaN
}

std::optional<PlatePositions> plate_positions(const ArmState& state) {
  if (state.space_backbone) {
    return state.space_backbone->leftCols<3>().cast<double>();
  }
  if (!state.backbone) {
    return std::nullopt;
  }
  PlatePositions positions = PlatePositions::Zero(state.backbone->rows(), 3);
  positions.leftCols<2>() = state.backbone->leftCols<2>().cast<double>();
  return positions;
}

Eigen::VectorXd checked_setpoints(const ArmDescription& arm,
                                  const Eigen::Ref<const Pressures>& setpoint_kpa) {
  if (setpoint_kpa.size() != arm.channel_count()) {
    throw InputError(fmt::format("{} set points; arm '{}' has {} {}", setpoint_kpa.size(), arm.name,
                                 arm.channel_count(), arm.is_spatial() ? "chambers" : "segments"));
  }
  Eigen::VectorXd result = setpoint_kpa.cast<double>();
  for (int channel = 0; channel < arm.channel_count(); ++channel) {
    const PressureLimits& limits = arm.limits_of_channel(channel);
    if (!allow(limits, result[channel], rounding_kpa(arm, channel))) {
      throw InputError(fmt::format("set point of {} is {} {unit}; expected {} to {} {unit}",
                                   channel_name(arm, channel), setpoint_kpa[channel],
                                   limits.lower_kpa, limits.upper_kpa,
                                   fmt::arg("unit", arm.command.unit)));
    }
    result[channel] = limits.clamped(result[channel]);
  }
  return result;
}

void throw_if_wrong(const std::string& wrong) {
  if (!wrong.empty()) {
    throw SystemFault(wrong);
  }
}

SafetyGate::SafetyGate(const ArmDescription& arm, std::vector<PressureLimits> limits_kpa,
                       bool check_rate, const SafetySettings& settings)
    : arm_(arm),
      limits_kpa_(std::move(limits_kpa)),
      check_rate_(check_rate),
      settings_(settings),
      largest_jump_m_(largest_jump_m(settings, arm)),
      setpoint_kpa_(Pressures::Zero(arm.channel_count())),
      reference_kpa_(Pressures::Zero(arm.channel_count())),
      frames_off_(std::size_t(arm.channel_count()), 0),
      history_{{setpoint_kpa_, reference_kpa_, reference_kpa_}} {
  settings_.following_time_s =
      std::max(settings_.following_time_s, kMinFollowingFrames * arm.frame_period_s());
}

std::string SafetyGate::check_command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  if (setpoint_kpa.size() != arm_.channel_count()) {
    return fmt::format("{} set points; arm '{}' has {} {}. They were not sent", setpoint_kpa.size(),
                       arm_.name, arm_.channel_count(),
                       arm_.is_spatial() ? "chambers" : "segments");
  }
  const double step_kpa = arm_.pressure_step_limit_kpa();
  const std::string& unit = arm_.command.unit;
  for (int s = 0; s < arm_.channel_count(); ++s) {
    const double value = setpoint_kpa[s];
    const PressureLimits& limits = limits_kpa(s);
    const double rounding = rounding_kpa(arm_, s);
    if (!allow(limits, value, rounding)) {
      return fmt::format(
          "set point of {} is {:.6g} {unit}; its limit is {:.6g} {unit}. It was not sent",
          channel_name(arm_, s), value, limit_of(limits, value), fmt::arg("unit", unit));
    }
    const double change_kpa = value - double(setpoint_kpa_[s]);
    if (check_rate_ && !(std::abs(change_kpa) <= step_kpa + rounding)) {
      return fmt::format(
          "set point of {} goes from {:.2f} to {:.2f} {unit} in a frame; the arm's rate limit "
          "allows {:.2f} {unit}. It was not sent",
          channel_name(arm_, s), setpoint_kpa_[s], value, step_kpa, fmt::arg("unit", unit));
    }
  }
  setpoint_kpa_ = setpoint_kpa;
  return "";
}

std::string SafetyGate::check_state(const ArmState& state) {
  std::string wrong = check_shape(state);
  if (wrong.empty()) {
    wrong = following(state);
  }
  return wrong.empty() ? never_sent(state) : wrong;
}

void SafetyGate::note_vented(const ArmState& state) {
  setpoint_kpa_.setZero();
  reference_kpa_ = state.pressure_kpa;
  std::fill(frames_off_.begin(), frames_off_.end(), 0);
  history_ = {{setpoint_kpa_, reference_kpa_, state.pressure_kpa}};
  plates_ = plate_positions(state);
  seen_at_s_ = state.time_s;
  frames_unseen_ = 0;
}

std::string SafetyGate::check_in_force(const ArmState& state) const {
  return state.setpoint_kpa ? over_limit(*state.setpoint_kpa, "reports a set point in force of")
                            : "";
}

std::string SafetyGate::over_limit(const Pressures& kpa, const char* what) const {
  for (int s = 0; s < arm_.channel_count(); ++s) {
    const PressureLimits& limits = limits_kpa(s);
    const double value = kpa[s];
    if (value > limits.upper_kpa + excess_kpa(s) || value < limits.lower_kpa - excess_kpa(s)) {
      return fmt::format(
          "{} {} {:.1f} kPa; its limit is {:.1f} kPa, with {:.1f} kPa allowed beyond",
          channel_name(arm_, s), what, value, limit_of(limits, value), excess_kpa(s));
    }
  }
  return "";
}

double SafetyGate::excess_kpa(int channel) const {
  return settings_.over_limit_percent / 100.0 * arm_.limits_of_channel(channel).largest_kpa();
}

std::string SafetyGate::check_shape(const ArmState& state) {
  std::string wrong = over_limit(state.pressure_kpa, "is at");
  if (wrong.empty()) {
    wrong = check_in_force(state);
  }
  ++frames_unseen_;
  const std::optional<PlatePositions> now = plate_positions(state);
  if (!wrong.empty() || !now) {
    return wrong;
  }
  const double since_s = state.time_s - seen_at_s_;  // long, where nobody looked meanwhile
  const int frames = std::max(frames_unseen_, int(std::lround(since_s * arm_.frame_rate_hz)));
  for (Eigen::Index i = 0; i < now->rows(); ++i) {
    const Eigen::RowVector3d position = now->row(i);
    if (settings_.fence && !is_within(*settings_.fence, position)) {
      const Eigen::Index coordinates = arm_.is_spatial() ? 3 : 2;
      return fmt::format("{} is at ({:.3f}) m, outside of the fence", plate_name(i),
                         fmt::join(position.data(), position.data() + coordinates, ", "));
    }
    if (plates_) {
      const double moved_m = (position - plates_->row(i)).norm();
      if (!(moved_m <= largest_jump_m_ * frames)) {
        return fmt::format(
            "{} jumped by {:.2f} cm within {} frame{}; more than {:.2f} cm per frame counts as no "
            "motion of this arm (jump_m of the mapping safety in the arm file, docs/hardware.md){}",
            plate_name(i), kCmPerM * moved_m, frames, frames == 1 ? "" : "s",
            kCmPerM * largest_jump_m_, another_scale(*now, arm_.length_m()));
      }
    }
  }
  plates_ = now;
  seen_at_s_ = state.time_s;
  frames_unseen_ = 0;
  return "";
}

std::string SafetyGate::following(const ArmState& state) {
  const auto step = float(arm_.pressure_step_limit_kpa());
  reference_kpa_ += (setpoint_kpa_ - reference_kpa_)
                        .cwiseMax(Pressures::Constant(reference_kpa_.size(), -step))
                        .cwiseMin(Pressures::Constant(reference_kpa_.size(), step));
  history_.push_back({setpoint_kpa_, reference_kpa_, state.pressure_kpa});
  const auto kept =
      std::size_t(std::max(stuck_frames(arm_), arm_.frames_in(settings_.following_time_s)));
  while (history_.size() > kept) {
    history_.pop_front();
  }
  // Valves lag, and some are faster than the arm's rate: a pressure may be anywhere between what
  // it was told and where that rate had led at any time of the last half second.
  for (int s = 0; s < arm_.channel_count(); ++s) {
    float low = reference_kpa_[s];
    float high = low;
    for (std::size_t k = first_recent(); k < history_.size(); ++k) {
      const auto& [told_kpa, led_kpa, measured_kpa] = history_[k];
      low = std::min({low, led_kpa[s], told_kpa[s]});
      high = std::max({high, led_kpa[s], told_kpa[s]});
    }
    const float measured = state.pressure_kpa[s];
    const double off_kpa = std::max({low - measured, measured - high, 0.0F});
    int& frames = frames_off_[s];
    frames = off_kpa > settings_.following_error_kpa ? frames + 1 : 0;
    std::string wrong = stuck(s);
    if (wrong.empty() && frames > arm_.frames_in(settings_.following_time_s)) {
      wrong = fmt::format(
          "{} is at {:.1f} kPa, {:.1f} kPa off where its set point of {:.1f} kPa has led since "
          "{:.2g} s. Check supply pressure, hoses and leaks",
          channel_name(arm_, s), measured, off_kpa, setpoint_kpa_[s], settings_.following_time_s);
    }
    if (!wrong.empty()) {
      return wrong;
    }
  }
  return "";
}

std::size_t SafetyGate::first_recent() const {
  const auto frames = std::size_t(arm_.frames_in(settings_.following_time_s));
  return history_.size() - std::min(history_.size(), frames);
}

std::string SafetyGate::never_sent(const ArmState& state) const {
  for (int s = 0; state.setpoint_kpa && s < arm_.channel_count(); ++s) {
    float low = setpoint_kpa_[s];
    float high = low;
    for (std::size_t k = first_recent(); k < history_.size(); ++k) {
      low = std::min(low, history_[k].setpoint_kpa[s]);
      high = std::max(high, history_[k].setpoint_kpa[s]);
    }
    const float reported = (*state.setpoint_kpa)[s];
    if (std::max(low - reported, reported - high) > excess_kpa(s)) {
      return fmt::format(
          "{} reports a set point in force of {:.1f} kPa; {:.1f} to {:.1f} kPa were sent within "
          "the last {} s, and {:.1f} kPa are allowed beyond",
          channel_name(arm_, s), reported, low, high, settings_.following_time_s, excess_kpa(s));
    }
  }
  return "";
}

std::string SafetyGate::stuck(int channel) const {
  const auto window = std::size_t(stuck_frames(arm_));
  if (history_.size() < window) {
    return "";
  }
  const std::size_t from = history_.size() - window;
  const auto until =
      history_.size() - std::size_t(std::max(arm_.frames_in(kStuckDelayS), kMinStuckDelayFrames));
  float low = history_[from].reference_kpa[channel];
  float high = low;
  float measured_low = history_[from].measured_kpa[channel];
  float measured_high = measured_low;
  for (std::size_t k = from; k < history_.size(); ++k) {
    if (k < until) {
      low = std::min(low, history_[k].reference_kpa[channel]);
      high = std::max(high, history_[k].reference_kpa[channel]);
    }
    measured_low = std::min(measured_low, history_[k].measured_kpa[channel]);
    measured_high = std::max(measured_high, history_[k].measured_kpa[channel]);
  }
  const double commanded_kpa = high - low;
  const double changed_kpa = measured_high - measured_low;
  if (commanded_kpa < settings_.stuck_change_kpa || changed_kpa > kStuckShare * commanded_kpa) {
    return "";
  }
  const Frame& then = history_[until - 1];  // what came after it has had no time to act
  if (std::abs(then.measured_kpa[channel] - then.setpoint_kpa[channel]) <
      settings_.stuck_change_kpa) {
    return "";  // it had arrived, faster than the arm's rate
  }
  return fmt::format(
      "{} stands still at {:.2f} kPa though its set point "
      "moved by {:.1f} kPa: a channel is stuck, or its sensor",
      channel_name(arm_, channel), history_.back().measured_kpa[channel], commanded_kpa);
}

}  // namespace limber
