#include "limber/sim/virtual_arm.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arm_physics.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/run/safety_gate.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "measurement.hpp"
#include "space_physics.hpp"

namespace limber {

namespace {

/// Simulator steps per frame: the fewest that keep the step within the arm's `time_step_s`.
int steps_per_frame(const ArmDescription& arm, const VirtualArmParameters& parameters) {
  constexpr double kRounding = 1e-9;  // so that 0.05 s of 0.001 s are 50 steps, not 51
  return std::max(1, int(std::ceil(arm.frame_period_s() / parameters.time_step_s - kRounding)));
}

/// The simulator behind either kind of arm; both are asked the same.
using Physics = std::variant<std::monostate, ArmPhysics, SpacePhysics>;

void write_shape(const ArmPhysics& physics, BackboneD& backbone) {
  const auto& plates = physics.kinematics().plates();
  backbone.resize(Eigen::Index(plates.size()), kPoseSize);
  for (std::size_t i = 0; i < plates.size(); ++i) {
    backbone.row(Eigen::Index(i)) << plates[i].position.x(), plates[i].position.y(),
        plates[i].theta_rad;
  }
}

/// @throws InputError if a part of the state is not as long as the arm's own.
void require_same_sizes(const VirtualArmState& state, const VirtualArmState& own,
                        const std::string& arm) {
  const auto require = [&](std::size_t found, std::size_t expected, const char* what) {
    refuse_if(found != expected, "virtual arm: {} of {} numbers in the state; arm '{}' has {}",
              what, found, arm, expected);
  };
  using Numbers = std::vector<double> VirtualArmState::*;
  for (const auto& [what, numbers] : std::initializer_list<std::pair<const char*, Numbers>>{
           {"position", &VirtualArmState::position},
           {"velocity", &VirtualArmState::velocity},
           {"warm_start", &VirtualArmState::warm_start},
           {"pressure_kpa", &VirtualArmState::pressure_kpa},
           {"flow_kpa_per_s", &VirtualArmState::flow_kpa_per_s},
           {"setpoint_kpa", &VirtualArmState::setpoint_kpa},
           {"braid_anchor_m", &VirtualArmState::braid_anchor_m},
           {"creep_m", &VirtualArmState::creep_m},
           {"table_anchor_m", &VirtualArmState::table_anchor_m},
           {"table_anchor_rad", &VirtualArmState::table_anchor_rad},
           {"joint_anchor_rad", &VirtualArmState::joint_anchor_rad}}) {
    require((state.*numbers).size(), (own.*numbers).size(), what);
  }
  for (const PendingSetpoint& pending : state.pending_setpoints) {
    require(pending.setpoint_kpa.size(), own.setpoint_kpa.size(), "pending_setpoints");
  }
  refuse_if(state.delayed.size() != own.delayed.size(),
            "virtual arm: {} delayed frames in the state; arm '{}' has {}", state.delayed.size(),
            arm, own.delayed.size());
}

}  // namespace

class VirtualArm::Simulation {
  /// What `question` answers of the physics, of whichever kind it is.
  template <class Simulator, class Question>
  static decltype(auto) ask(Simulator& of, Question&& question) {
    return of.arm_.is_spatial() ? question(std::get<SpacePhysics>(of.physics_))
                                : question(std::get<ArmPhysics>(of.physics_));
  }

 public:
  Simulation(const ArmDescription& arm, const VirtualArmOptions& options)
      : arm_(arm),
        options_(options),
        parameters_(virtual_arm_parameters(arm)),
        steps_per_frame_(steps_per_frame(arm, parameters_)),
        time_step_s_(arm.frame_period_s() / steps_per_frame_),
        measurement_(options) {
    state_.setpoint_kpa.resize(arm.channel_count());
    be(arm);
    ask(*this, [&](auto& physics) {
      physics.rest(state_);
      physics.restore(state_);
    });
    check_options(options);
    check_parts();
    dead_steps_ = std::llround(parameters_.valve_dead_time_s / time_step_s_);
    const auto latency_steps = int(std::lround(options.latency_s / time_step_s_));
    frames_late_ = latency_steps / steps_per_frame_;
    steps_late_ = latency_steps % steps_per_frame_;
    state_.delivered = measure();
    for (int frame = 0; frame < frames_late_; ++frame) {
      state_.delayed.push_back(state_.delivered);
    }
  }

  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
    const Eigen::VectorXd commanded = checked_setpoints(arm_, setpoint_kpa);
    if (!fault_.empty()) {
      throw SystemFault(fault_);
    }
    state_.pending_setpoints.push_back(
        {state_.step + dead_steps_, {commanded.begin(), commanded.end()}});
    // The frame to deliver `frames_late_` frames from now is taken `steps_late_` before its end.
    for (int step = 1; step <= steps_per_frame_; ++step) {
      advance();
      if (step == steps_per_frame_ - steps_late_) {
        state_.delayed.push_back(measure());
      }
    }
    state_.delivered = std::move(state_.delayed.front());
    state_.delayed.pop_front();
    state_.delivered.time_s = time_s();
    return state_.delivered;
  }

  void vent() noexcept {
    std::ranges::fill(state_.setpoint_kpa, 0.0);
    state_.pending_setpoints.clear();
    state_.vented = true;
  }

  VirtualArmState save() const {
    VirtualArmState state = state_;
    ask(*this, [&](const auto& physics) { physics.save(state); });
    state.noise_position = measurement_.position();
    return state;
  }

  void restore(const VirtualArmState& state) {
    require_same_sizes(state, save(), arm_.name);
    state_ = state;
    become_later();
    ask(*this, [&](auto& physics) { physics.restore(state); });
    measurement_.seek(state.noise_position);
    fault_.clear();
  }

  double time_s() const { return double(state_.step) * time_step_s_; }
  double time_step_s() const { return time_step_s_; }
  double frame_period_s() const { return arm_.frame_period_s(); }
  /// @throws InputError for an arm of the other kind.
  const ArmPhysics& in_plane(const char* what) const {
    require_planar(arm_, what);
    return std::get<ArmPhysics>(physics_);
  }
  const SpacePhysics& in_space(const char* what) const {
    refuse_if(!arm_.is_spatial(), "{} is of arms in space; '{}' is in a plane", what, arm_.name);
    return std::get<SpacePhysics>(physics_);
  }
  const std::vector<double>& pressure_kpa() const { return state_.pressure_kpa; }
  double energy_j() const {
    return ask(*this, [&](const auto& physics) { return physics.energy_j(state_); });
  }
  const ArmState& delivered() const { return state_.delivered; }
  void set_observer(StepObserver observer) { observer_ = std::move(observer); }

 private:
  /// Its state is still to be restored.
  void be(const ArmDescription& arm) {
    const VirtualArmParameters parameters = virtual_arm_parameters(arm);
    if (arm.is_spatial()) {
      physics_.emplace<SpacePhysics>(arm, parameters, time_step_s_);
    } else {
      physics_.emplace<ArmPhysics>(arm, parameters, time_step_s_);
    }
  }

  void check_parts() const {
    refuse_if(parameters_.weak_side_loss > 0.0 && parameters_.weak_side >= 2 * arm_.segment_count(),
              "virtual arm: weak_side = {}; arm '{}' has sides "
              "0 to {} (2 x segment, + 1 for its right side)",
              parameters_.weak_side, arm_.name, 2 * arm_.segment_count() - 1);
    if (parameters_.leak_share > 0.0 && parameters_.leaking_channel >= arm_.channel_count()) {
      throw InputError(fmt::format(
          "virtual arm: leaking_channel = {}; arm '{}' has {} 0 to {}", parameters_.leaking_channel,
          arm_.name, arm_.is_spatial() ? "chambers" : "segments", arm_.channel_count() - 1));
    }
  }

  void take_arrived_setpoints() {
    std::deque<PendingSetpoint>& pending = state_.pending_setpoints;
    while (!pending.empty() && pending.front().step <= state_.step) {
      state_.setpoint_kpa = std::move(pending.front().setpoint_kpa);
      pending.pop_front();
      const bool is_rest =
          std::ranges::all_of(state_.setpoint_kpa, [](double kpa) { return kpa == 0.0; });
      state_.vented = state_.vented && is_rest;
    }
  }

  /// The arm that it is at this moment, in the state that it is in.
  void become_later() {
    const bool is_later = options_.later && time_s() >= options_.later_from_s;
    if (std::exchange(is_later_, is_later) == is_later) {
      return;
    }
    const VirtualArmState now = save();
    be(is_later ? *options_.later : arm_);
    ask(*this, [&](auto& physics) { physics.restore(now); });
  }

  void advance() {
    become_later();
    take_arrived_setpoints();
    const std::string complaint = ask(*this, [&](auto& physics) { return physics.step(state_); });
    ++state_.step;
    if (!complaint.empty()) {
      fail(complaint);
    }
    if (observer_) {
      write_shape(in_plane("an observer"), seen_);
      observer_(time_s(), seen_);
    }
  }

  [[noreturn]] void fail(const std::string& complaint) {
    fault_ = fmt::format(
        "the virtual arm '{}' blew up at {:.4f} s ({}); pressures "
        "[{:.4g}] kPa, set points [{:.4g}] kPa, time step {:.3g} s: check "
        "virtual_arm in the arm file, or make its time_step_s smaller",
        arm_.name, time_s(), complaint, fmt::join(pressure_kpa(), ", "),
        fmt::join(state_.setpoint_kpa, ", "), time_step_s_);
    vent();
    throw SystemFault(fault_);
  }

  /// The state at this moment, as sensors see it.
  ArmState measure() {
    if (arm_.is_spatial()) {
      SpaceBackboneD plates;
      std::get<SpacePhysics>(physics_).write_plates(plates);
      return measurement_.of(time_s(), pressure_kpa(), std::move(plates));
    }
    BackboneD backbone;
    write_shape(std::get<ArmPhysics>(physics_), backbone);
    return measurement_.of(time_s(), pressure_kpa(), std::move(backbone));
  }

  ArmDescription arm_;
  VirtualArmOptions options_;
  VirtualArmParameters parameters_;
  int steps_per_frame_;
  double time_step_s_;
  Physics physics_;
  bool is_later_ = false;  // of `options_.later`
  Measurement measurement_;
  int frames_late_ = 0;
  int steps_late_ = 0;
  std::int64_t dead_steps_ = 0;
  StepObserver observer_;
  BackboneD seen_;  // what the observer is shown
  std::string fault_;

  VirtualArmState state_;  // but for joints and noise_position, which `save` asks for
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
  const auto frames = int(std::ceil(seconds / simulation_->frame_period_s() - 1e-9));
  for (int frame = 0; frame < frames; ++frame) {
    throw_if_interrupted();
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
  write_shape(simulation_->in_plane("true_backbone"), backbone);
  return backbone;
}

SpaceBackboneD VirtualArm::true_plates() const {
  SpaceBackboneD plates;
  simulation_->in_space("true_plates").write_plates(plates);
  return plates;
}

Eigen::VectorXd VirtualArm::true_pressure_kpa() const {
  const std::vector<double>& kpa = simulation_->pressure_kpa();
  return Eigen::Map<const Eigen::VectorXd>(kpa.data(), std::ssize(kpa));
}

double VirtualArm::left_strain(int segment) const {
  return simulation_->in_plane("left_strain").side_strain(segment, 1.0);
}

double VirtualArm::right_strain(int segment) const {
  return simulation_->in_plane("right_strain").side_strain(segment, -1.0);
}

double VirtualArm::chamber_strain(int channel) const {
  return simulation_->in_space("chamber_strain").chamber_strain(channel);
}

double VirtualArm::energy_j() const {
  return simulation_->energy_j();
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
