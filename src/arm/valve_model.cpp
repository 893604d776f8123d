#include "limber/arm/valve_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kLongestTimeConstantS = 100.0;

bool within(double value, double low, double high) {
  return value >= low && value <= high;  // false for NaN
}

std::string fault_of(const ValveDirection& direction, const char* name) {
  if (!within(direction.time_constant_s, 0.0, kLongestTimeConstantS)) {
    return fmt::format("{}.time_constant_s = {}; expected 0 to {} s", name,
                       direction.time_constant_s, kLongestTimeConstantS);
  }
  if (!(direction.rate_limit_kpa_per_s > 0.0)) {
    return fmt::format("{}.rate_limit_kpa_per_s = {}; expected a rate > 0, or infinity for none",
                       name, direction.rate_limit_kpa_per_s);
  }
  return {};
}

std::string fault_of(const SegmentValves& valves) {
  for (const std::string& fault :
       {fault_of(valves.inflating, "inflating"), fault_of(valves.venting, "venting")}) {
    if (!fault.empty()) {
      return fault;
    }
  }
  if (!within(valves.dead_time_s, 0.0, kLongestDeadTimeS)) {
    return fmt::format("dead_time_s = {}; expected 0 to {} s", valves.dead_time_s,
                       kLongestDeadTimeS);
  }
  if (!(valves.dead_band_kpa >= 0.0) || !std::isfinite(valves.dead_band_kpa)) {
    return fmt::format("dead_band_kpa = {}; expected a finite number >= 0", valves.dead_band_kpa);
  }
  return {};
}

/// One frame of one column; `motions` empty for ideal valves. Not inlined, so that every caller
/// runs the same instructions and gets the same bits.
template <class Scalar>
[[gnu::noinline]] void step_column(const std::vector<ValveMotion>& motions, int segments,
                                   int setpoint_count, const Scalar* setpoint, Scalar* state) {
  Scalar* history = state + segments;  // newest first
  for (int i = 0; i < segments; ++i) {
    if (motions.empty()) {
      state[i] = setpoint[i];
      continue;
    }
    const ValveMotion& motion = motions[std::size_t(i)];
    const int late = motion.frames_late();
    const Scalar newer = late == 0 ? setpoint[i] : history[(late - 1) * segments + i];
    const Scalar older = motion.splits() ? history[late * segments + i] : newer;
    state[i] = static_cast<Scalar>(motion.after_frame(state[i], older, newer));
  }
  const auto kept = std::ptrdiff_t(setpoint_count - 1) * segments;
  std::copy_backward(history, history + kept, history + kept + segments);
  std::copy(setpoint, setpoint + segments, history);
}

void require_size(const char* what, Eigen::Index found, Eigen::Index expected) {
  refuse_if(found != expected, "valve model: {} of size {}; expected {}", what, found, expected);
}

}  // namespace

std::string ValveParameters::hash() const {
  if (is_ideal()) {
    return {};
  }
  std::string text = has_sides ? "sides" : "no sides";
  for (const SegmentValves& s : segments) {
    text += fmt::format(" {} {} {} {} {} {}", s.inflating.time_constant_s,
                        s.inflating.rate_limit_kpa_per_s, s.venting.time_constant_s,
                        s.venting.rate_limit_kpa_per_s, s.dead_time_s, s.dead_band_kpa);
  }
  return content_hash(text);
}

std::string why_unusable(const ValveParameters& parameters, const ArmDescription& arm) {
  // A chamber has one side: what has none says the same of it.
  if (!arm.is_spatial() && !parameters.is_ideal() &&
      parameters.has_sides != arm.command.is_pressure_kpa()) {
    return fmt::format("has_sides = {}; arm '{}' is driven by '{}' in {}, which has {}",
                       parameters.has_sides, arm.name, arm.command.name, arm.command.unit,
                       arm.command.is_pressure_kpa() ? "two sides" : "no sides");
  }
  return why_unusable(parameters, arm.channel_count());
}

std::string why_unusable(const ValveParameters& parameters, int segment_count) {
  if (parameters.is_ideal()) {
    return {};
  }
  if (int(parameters.segments.size()) != segment_count) {
    return fmt::format("{} segments found; the arm has {}", parameters.segments.size(),
                       segment_count);
  }
  for (std::size_t i = 0; i < parameters.segments.size(); ++i) {
    const std::string fault = fault_of(parameters.segments[i]);
    if (!fault.empty()) {
      return fmt::format("{}: {}", segment_name(i), fault);
    }
  }
  return {};
}

ValveModel::ValveModel(const ArmDescription& arm) : ValveModel(arm, ValveParameters{}) {}

ValveModel::ValveModel(const ArmDescription& arm, ValveParameters parameters)
    : parameters_(std::move(parameters)), segment_count_(arm.channel_count()) {
  const std::string fault = why_unusable(parameters_, arm);
  if (!fault.empty()) {
    throw InputError("valves: " + fault);
  }
  for (const SegmentValves& valves : parameters_.segments) {
    motions_.emplace_back(valves, parameters_.has_sides, arm.frame_period_s());
    setpoint_count_ = std::max(setpoint_count_, motions_.back().pending_setpoints());
  }
}

ValveModel ValveModel::ideal(int segment_count) {
  return ValveModel(segment_count);
}

Eigen::VectorXf ValveModel::settled_state(const Eigen::Ref<const Pressures>& kpa) const {
  require_size("pressures", kpa.size(), segment_count_);
  return kpa.replicate(1 + setpoint_count_, 1);
}

void ValveModel::step(const Eigen::Ref<const Pressures>& setpoint_kpa,
                      Eigen::Ref<Eigen::VectorXf> state) const {
  require_size("set points", setpoint_kpa.size(), segment_count_);
  require_size("a state", state.size(), state_size());
  step_column(motions_, segment_count_, setpoint_count_, setpoint_kpa.data(), state.data());
}

Eigen::MatrixXd ValveModel::run(const Eigen::Ref<const Eigen::MatrixXd>& setpoint_kpa,
                                const Eigen::Ref<const Eigen::VectorXd>& first_pressure_kpa) const {
  require_size("set points", setpoint_kpa.rows(), segment_count_);
  require_size("first pressures", first_pressure_kpa.size(), segment_count_);
  Eigen::MatrixXd pressure(setpoint_kpa.rows(), setpoint_kpa.cols());
  if (pressure.cols() == 0) {
    return pressure;
  }
  Eigen::VectorXd state = setpoint_kpa.col(0).replicate(1 + setpoint_count_, 1);
  state.head(segment_count_) = first_pressure_kpa;
  pressure.col(0) = first_pressure_kpa;
  for (Eigen::Index k = 1; k < pressure.cols(); ++k) {
    step_column(motions_, segment_count_, setpoint_count_, setpoint_kpa.col(k).data(),
                state.data());
    pressure.col(k) = state.head(segment_count_);
  }
  return pressure;
}

int ValveModel::frames_to_settle(const Eigen::Ref<const Eigen::VectorXf>& state,
                                 const Eigen::Ref<const Pressures>& tolerance_kpa, int most) const {
  require_size("a state", state.size(), state_size());
  require_size("tolerances", tolerance_kpa.size(), segment_count_);
  Eigen::VectorXf moving = state;
  const Pressures held = state.segment(segment_count_, segment_count_);
  int frames = 0;  // after which all were within the tolerance, so far
  for (int frame = 0; frame <= most; ++frame) {
    const bool within =
        ((moving.head(segment_count_) - held).cwiseAbs().array() <= tolerance_kpa.array()).all();
    if (!within) {
      frames = std::min(frame + 1, most);
    } else if (frame >= setpoint_count_) {
      break;  // no older set point is under way: from here on pressures only come nearer
    }
    step(held, moving);
  }
  return frames;
}

}  // namespace limber
