#pragma once

#include <algorithm>
#include <cmath>

#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

/// Valves of segments, in space of chambers, and the PD controller that drives them:
/// docs/virtual-arm.md, (V8), (V9).
///
/// One signed pressure stands for both sides, so they are never pressurised together: a set point
/// of the other sign vents one side and then inflates the other.
/// Threads: constant after construction; share it freely.
class Pneumatics {
 public:
  Pneumatics(const VirtualArmParameters& parameters, double time_step_s)
      : parameters_(parameters),
        time_step_s_(time_step_s),
        valve_response_(1.0 - std::exp(-time_step_s / parameters.valve_lag_s)),
        inflate_limit_kpa_per_s_(own_or_common(parameters.inflate_rate_limit_kpa_per_s)),
        vent_limit_kpa_per_s_(own_or_common(parameters.vent_rate_limit_kpa_per_s)),
        leak_response_(leak_response(parameters, time_step_s)) {}

  /// One simulator step of all channels toward their set points; errors within the dead band close
  /// the valves, unless it is vented for safety.
  void step(VirtualArmState& state) const {
    for (std::size_t channel = 0; channel < state.pressure_kpa.size(); ++channel) {
      double& pressure_kpa = state.pressure_kpa[channel];
      double& flow_kpa_per_s = state.flow_kpa_per_s[channel];
      const double error = state.setpoint_kpa[channel] - pressure_kpa;
      const bool closed = !state.vented && std::abs(error) <= parameters_.pressure_dead_band_kpa;
      const double demand = closed ? 0.0
                                   : parameters_.controller_proportional_gain * error -
                                         parameters_.controller_derivative_gain_s * flow_kpa_per_s;
      const bool vents = demand * pressure_kpa < 0.0;
      const double time_constant =
          vents ? parameters_.vent_time_constant_s : parameters_.inflate_time_constant_s;
      const double limit = vents ? vent_limit_kpa_per_s_ : inflate_limit_kpa_per_s_;
      const double flow = std::clamp(demand / time_constant, -limit, limit);
      // Exact for a demand that is constant over the step, and second order in the pressure.
      const double before = flow_kpa_per_s;
      flow_kpa_per_s += valve_response_ * (flow - before);
      pressure_kpa += 0.5 * time_step_s_ * (before + flow_kpa_per_s);
      if (channel == std::size_t(parameters_.leaking_channel)) {
        pressure_kpa *= leak_response_;
      }
    }
  }

 private:
  double own_or_common(double limit) const {
    return limit > 0.0 ? limit : parameters_.pressure_rate_limit_kpa_per_s;
  }

  /// What a step leaves of the pressure where the controller's gain balances the leak at that share
  /// less than the set point. 1: none.
  static double leak_response(const VirtualArmParameters& parameters, double time_step_s) {
    const double share = parameters.leak_share;
    const double per_s = share / (1.0 - share) * parameters.controller_proportional_gain /
                         parameters.inflate_time_constant_s;
    return std::exp(-per_s * time_step_s);
  }

  VirtualArmParameters parameters_;
  double time_step_s_;
  double valve_response_;
  double inflate_limit_kpa_per_s_;
  double vent_limit_kpa_per_s_;
  double leak_response_;
};

}  // namespace limber
