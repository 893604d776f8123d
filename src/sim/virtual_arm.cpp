#include "limber/sim/virtual_arm.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arm_physics.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

constexpr double kMaxClampedKpa = 1e-3;  // excess of a set point that is clamped, not refused

void check_option(const char* name, double value, double high) {
  if (!(value >= 0.0 && value <= high)) {
    throw InputError(
        fmt::format("virtual arm: {} = {}; expected a number from 0 to {}", name, value, high));
  }
}

void check_options(const VirtualArmOptions& options) {
  constexpr double kLongestLatencyS = 10.0;
  constexpr double kLongestLossS = 1e6;
  constexpr double kMaxNoise = 1e3;
  check_option("noise_m", options.noise_m, kMaxNoise);
  check_option("noise_rad", options.noise_rad, kMaxNoise);
  check_option("noise_kpa", options.noise_kpa, kMaxNoise);
  check_option("drop_rate", options.drop_rate, 1.0);
  check_option("latency_s", options.latency_s, kLongestLatencyS);
  check_option("lost_from_s", options.lost_from_s, kLongestLossS);
  check_option("lost_for_s", options.lost_for_s, kLongestLossS);
  check_option("later_from_s", options.later_from_s, kLongestLossS);
}

/// Simulator steps per frame: the fewest that keep the step within the arm's `time_step_s`.
int steps_per_frame(const ArmDescription& arm, const VirtualArmParameters& parameters) {
  constexpr double kRounding = 1e-9;  // so that 0.05 s of 0.001 s are 50 steps, not 51
  return std::max(
      1, static_cast<int>(std::ceil(arm.frame_period_s() / parameters.time_step_s - kRounding)));
}

}  // namespace

class VirtualArm::Simulation {
 public:
  Simulation(const ArmDescription& arm, const VirtualArmOptions& options)
      : arm_(arm),
        options_(options),
        parameters_(virtual_arm_parameters(arm)),
        steps_per_frame_(steps_per_frame(arm, parameters_)),
        time_step_s_(arm.frame_period_s() / steps_per_frame_),
        physics_(std::make_unique<ArmPhysics>(arm, parameters_, time_step_s_)),
        noise_(options.seed, options.stream),
        setpoint_kpa_(arm.segments.size()) {
    check_options(options);
    check_weak_side();
    dead_steps_ = std::llround(parameters_.valve_dead_time_s / time_step_s_);
    const auto latency_steps = static_cast<int>(std::lround(options.latency_s / time_step_s_));
    frames_late_ = latency_steps / steps_per_frame_;
    steps_late_ = latency_steps % steps_per_frame_;
    delivered_ = measure();
    for (int frame = 0; frame < frames_late_; ++frame) {
      delayed_.push_back(delivered_);
    }
  }

  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
    std::vector<double> commanded = checked(setpoint_kpa);
    if (!fault_.empty()) {
      throw SystemFault(fault_);
    }
    pending_.push_back({step_ + dead_steps_, std::move(commanded)});
    // The frame to deliver `frames_late_` frames from now is taken `steps_late_` before its end.
    for (int step = 1; step <= steps_per_frame_; ++step) {
      advance();
      if (step == steps_per_frame_ - steps_late_) {
        delayed_.push_back(measure());
      }
    }
    delivered_ = std::move(delayed_.front());
    delayed_.pop_front();
    delivered_.time_s = time_s();
    return delivered_;
  }

  void vent() noexcept {
    std::fill(setpoint_kpa_.begin(), setpoint_kpa_.end(), 0.0);
    pending_.clear();
    vented_ = true;
  }

  VirtualArmState save() const {
    VirtualArmState state;
    physics_->save(state);
    state.step = step_;
    state.setpoint_kpa = setpoint_kpa_;
    state.pending_setpoints = pending_;
    state.vented = vented_;
    state.noise_position = noise_.position();
    state.delayed = delayed_;
    state.delivered = delivered_;
    return state;
  }

  void restore(const VirtualArmState& state) {
    const VirtualArmState own = save();
    if (state.position.size() != own.position.size() ||
        state.pressure_kpa.size() != own.pressure_kpa.size() ||
        state.delayed.size() != own.delayed.size()) {
      throw InputError(
          fmt::format("virtual arm: a state of {} joints, {} segments "
                      "and {} delayed frames; arm '{}' has {}, {} and {}",
                      state.position.size(), state.pressure_kpa.size(), state.delayed.size(),
                      arm_.name, own.position.size(), own.pressure_kpa.size(), own.delayed.size()));
    }
    step_ = state.step;
    become_later();
    physics_->restore(state);
    setpoint_kpa_ = state.setpoint_kpa;
    pending_ = state.pending_setpoints;
    vented_ = state.vented;
    noise_.seek(state.noise_position);
    delayed_ = state.delayed;
    delivered_ = state.delivered;
    fault_.clear();
  }

  void write_backbone(BackboneD& backbone) const {
    const auto& plates = physics_->kinematics().plates();
    backbone.resize(static_cast<Eigen::Index>(plates.size()), kPoseSize);
    for (std::size_t i = 0; i < plates.size(); ++i) {
      backbone.row(static_cast<Eigen::Index>(i)) << plates[i].position.x(), plates[i].position.y(),
          plates[i].theta_rad;
    }
  }

  double time_s() const { return static_cast<double>(step_) * time_step_s_; }
  double time_step_s() const { return time_step_s_; }
  double frame_period_s() const { return arm_.frame_period_s(); }
  const ArmPhysics& physics() const { return *physics_; }
  const ArmState& delivered() const { return delivered_; }
  void set_observer(StepObserver observer) { observer_ = std::move(observer); }

 private:
  void check_weak_side() const {
    if (parameters_.weak_side_loss > 0.0 && parameters_.weak_side >= 2 * arm_.segment_count()) {
      throw InputError(
          fmt::format("virtual arm: weak_side = {}; arm '{}' has sides "
                      "0 to {} (2 x segment, + 1 for its right side)",
                      parameters_.weak_side, arm_.name, 2 * arm_.segment_count() - 1));
    }
  }

  /// Set points within the arm's limits. Changes nothing if it throws.
  std::vector<double> checked(const Eigen::Ref<const Pressures>& setpoint_kpa) const {
    if (setpoint_kpa.size() != arm_.channel_count()) {
      throw InputError(fmt::format("{} set points; arm '{}' has {} segments", setpoint_kpa.size(),
                                   arm_.name, arm_.channel_count()));
    }
    std::vector<double> result;
    for (int s = 0; s < arm_.channel_count(); ++s) {
      const PressureLimits& limits = arm_.segments[static_cast<std::size_t>(s)].pressure_limit_kpa;
      const double value = setpoint_kpa[s];
      if (!(value >= limits.lower_kpa - kMaxClampedKpa &&
            value <= limits.upper_kpa + kMaxClampedKpa)) {
        throw InputError(fmt::format("set point of {} is {} kPa; expected {} to {} kPa",
                                     segment_name(s), setpoint_kpa[s], limits.lower_kpa,
                                     limits.upper_kpa));
      }
      result.push_back(limits.clamped(value));
    }
    return result;
  }

  void take_arrived_setpoints() {
    while (!pending_.empty() && pending_.front().step <= step_) {
      setpoint_kpa_ = std::move(pending_.front().setpoint_kpa);
      pending_.pop_front();
      vented_ = false;
    }
  }

  /// The arm that it is at this moment, in the state that it is in.
  void become_later() {
    const bool is_later = options_.later && time_s() >= options_.later_from_s;
    if (std::exchange(is_later_, is_later) == is_later) {
      return;
    }
    VirtualArmState state;
    physics_->save(state);
    const ArmDescription& arm = is_later ? *options_.later : arm_;
    physics_ = std::make_unique<ArmPhysics>(arm, virtual_arm_parameters(arm), time_step_s_);
    physics_->restore(state);
  }

  void advance() {
    become_later();
    take_arrived_setpoints();
    const std::string complaint = physics_->step(setpoint_kpa_, vented_);
    ++step_;
    if (!complaint.empty()) {
      fail(complaint);
    }
    if (observer_) {
      write_backbone(seen_);
      observer_(time_s(), seen_);
    }
  }

  [[noreturn]] void fail(const std::string& complaint) {
    std::vector<double> pressures;
    for (const SegmentAir& air : physics_->air()) {
      pressures.push_back(air.pressure_kpa);
    }
    fault_ = fmt::format(
        "the virtual arm '{}' blew up at {:.4f} s ({}); pressures "
        "[{:.4g}] kPa, set points [{:.4g}] kPa, time step {:.3g} s: check "
        "virtual_arm in the arm file, or make its time_step_s smaller",
        arm_.name, time_s(), complaint, fmt::join(pressures, ", "), fmt::join(setpoint_kpa_, ", "),
        time_step_s_);
    vent();
    throw SystemFault(fault_);
  }

  /// The true state at this moment with the options' noise and drops; always the same number of
  /// samples.
  ArmState measure() {
    BackboneD backbone;
    write_backbone(backbone);
    ArmState state;
    state.time_s = time_s();
    state.pressure_kpa.resize(arm_.channel_count());
    for (int s = 0; s < arm_.channel_count(); ++s) {
      state.pressure_kpa[s] = static_cast<float>(
          physics_->air()[static_cast<std::size_t>(s)].pressure_kpa + noise(options_.noise_kpa));
    }
    for (Eigen::Index row = 0; row < backbone.rows(); ++row) {
      backbone(row, 0) += noise(options_.noise_m);
      backbone(row, 1) += noise(options_.noise_m);
      backbone(row, 2) += noise(options_.noise_rad);
    }
    const bool lost = options_.drop_rate > 0.0 && noise_.uniform() < options_.drop_rate;
    if (!lost && !is_in_outage()) {
      state.backbone = backbone.cast<float>();
    }
    return state;
  }

  bool is_in_outage() const {
    const double since_s = time_s() - options_.lost_from_s;
    return since_s >= 0.0 && since_s < options_.lost_for_s;
  }

  double noise(double deviation) { return deviation > 0.0 ? deviation * noise_.normal() : 0.0; }

  ArmDescription arm_;
  VirtualArmOptions options_;
  VirtualArmParameters parameters_;
  int steps_per_frame_;
  double time_step_s_;
  std::unique_ptr<ArmPhysics> physics_;
  bool is_later_ = false;  // of `options_.later`
  RandomStream noise_;
  int frames_late_ = 0;
  int steps_late_ = 0;
  std::int64_t dead_steps_ = 0;
  StepObserver observer_;
  BackboneD seen_;  // what the observer is shown
  std::string fault_;

  std::int64_t step_ = 0;
  std::vector<double> setpoint_kpa_;  // what the pressure controller goes by
  std::deque<PendingSetpoint> pending_;
  bool vented_ = false;
  std::deque<ArmState> delayed_;
  ArmState delivered_;
};

VirtualArm::VirtualArm(const ArmDescription& arm, const VirtualArmOptions& options) {
  require_pressure_driven(arm, "the virtual arm");
  simulation_ = std::make_unique<Simulation>(arm, options);
}
VirtualArm::~VirtualArm() = default;
VirtualArm::VirtualArm(VirtualArm&&) noexcept = default;
VirtualArm& VirtualArm::operator=(VirtualArm&&) noexcept = default;

const ArmState& VirtualArm::state() const {
  return simulation_->delivered();
}

const ArmState& VirtualArm::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  return simulation_->command(setpoint_kpa);
}

void VirtualArm::vent() noexcept {
  simulation_->vent();
}

const ArmState& VirtualArm::settle(const Eigen::Ref<const Pressures>& setpoint_kpa,
                                   double seconds) {
  const auto frames = static_cast<int>(std::ceil(seconds / simulation_->frame_period_s() - 1e-9));
  for (int frame = 0; frame < frames; ++frame) {
    command(setpoint_kpa);
  }
  return state();
}

VirtualArmState VirtualArm::save() const {
  return simulation_->save();
}

void VirtualArm::restore(const VirtualArmState& state) {
  simulation_->restore(state);
}

void VirtualArm::set_observer(StepObserver observer) {
  simulation_->set_observer(std::move(observer));
}

BackboneD VirtualArm::true_backbone() const {
  BackboneD backbone;
  simulation_->write_backbone(backbone);
  return backbone;
}

Eigen::VectorXd VirtualArm::true_pressure_kpa() const {
  const auto& air = simulation_->physics().air();
  Eigen::VectorXd pressures(static_cast<Eigen::Index>(air.size()));
  for (std::size_t s = 0; s < air.size(); ++s) {
    pressures[static_cast<Eigen::Index>(s)] = air[s].pressure_kpa;
  }
  return pressures;
}

double VirtualArm::left_strain(int segment) const {
  return simulation_->physics().side_strain(segment, 1.0);
}

double VirtualArm::right_strain(int segment) const {
  return simulation_->physics().side_strain(segment, -1.0);
}

double VirtualArm::energy_j() const {
  return simulation_->physics().energy_j();
}

double VirtualArm::time_step_s() const {
  return simulation_->time_step_s();
}

ExecutionResult execute(const ArmDescription& arm, const Environment& environment, const Plan& plan,
                        VirtualArm& driver, const ExecutionSettings& settings) {
  const TrueShape truth{
      [&driver] { return driver.true_backbone(); },
      [&driver](StepObserver observer) { driver.set_observer(std::move(observer)); }};
  return execute(arm, environment, plan, static_cast<ArmDriver&>(driver), truth, settings);
}

}  // namespace limber
