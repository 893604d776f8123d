#pragma once

#include <cmath>

#include "limber/sim/virtual_arm_parameters.hpp"
#include "spring_slider.hpp"

namespace limber {

/// Tension of one McKibben actuator over its strain and pressure: docs/virtual-arm.md, (V3)–(V5).
/// Surface measured by Olson (2019), stretched along its strain. Strain e < 0 is contraction;
/// tension in N, > 0 pulls.
///
/// Threads: constant after construction; share it freely.
class ActuatorLaw {
 public:
  explicit ActuatorLaw(const VirtualArmParameters& parameters) : parameters_(parameters) {}

  /// (V3) Pressure [kPa] at which the actuator of strain e just pulls.
  double threshold_kpa(double strain) const {
    const double e = strain / parameters_.actuator_strain_scale;
    return e < 0.0 ? quartic(parameters_.actuator_threshold_kpa, e) : 0.0;
  }

  /// (V4), (V5) Tension; continuous in both arguments. @param pressure_kpa  ≥ 0.
  double tension_n(double strain, double pressure_kpa) const {
    const double e =
        strain / parameters_.actuator_strain_scale;  // on Olson's own surface, whose scale is 1
    const double threshold = threshold_kpa(strain);
    const double reach = parameters_.actuator_strain_offset + e;
    if (e >= 0.0) {
      return parameters_.actuator_gain * reach * reach * pressure_kpa +
             quartic(parameters_.actuator_extension_n, e);
    }
    if (pressure_kpa >= threshold) {
      return parameters_.actuator_gain * reach * reach * (pressure_kpa - threshold);
    }
    return quartic(parameters_.actuator_compression_n, e) * (1.0 - pressure_kpa / threshold);
  }

  /// Work [J per metre of actuator] stored by straining an unpressurised actuator from 0 to e.
  double passive_energy_n(double strain) const {
    const double e = strain / parameters_.actuator_strain_scale;
    const QuarticCoefficients& c =
        e < 0.0 ? parameters_.actuator_compression_n : parameters_.actuator_extension_n;
    return parameters_.actuator_strain_scale *
           (e * e * (c[0] / 2 + e * (c[1] / 3 + e * (c[2] / 4 + e * c[3] / 5))));
  }

 private:
  static double quartic(const QuarticCoefficients& c, double x) {
    return x * (c[0] + x * (c[1] + x * (c[2] + x * c[3])));
  }

  VirtualArmParameters parameters_;
};

/// Tension of what pulls and pushes along one gap: a side of an arm in a plane, or a chamber of one
/// in space. Actuator, elasticity, creep and the friction of its braid; docs/virtual-arm.md, (V3)
/// to (V7), (V10) and (V13). Tension in N, > 0 pulls.
///
/// Threads: constant after construction; share it freely.
class SideLaw {
 public:
  /// What never changes of one side of one gap.
  struct Side {
    double length_m = 0.0;              ///< of the gap at rest
    double strength = 1.0;              ///< × actuators per side, where it contracts
    bool extends = false;               ///< by pressure; else it contracts, as a McKibben actuator
    double full_force_n_per_kpa = 0.0;  ///< at rest length, its size
    double full_pressure_kpa = 0.0;     ///< larger limit of what it is commanded by
  };
  /// What it remembers.
  struct Memory {
    double& braid_anchor_m;
    double& creep_m;
  };

  SideLaw(const VirtualArmParameters& parameters, double time_step_s)
      : parameters_(parameters), time_step_s_(time_step_s), actuator_(parameters) {}

  /// @param strength  × that of one actuator, or of one chamber that extends
  Side side(double length_m, double strength, bool extends, double full_pressure_kpa) const {
    constexpr double kReferencePressureKpa = 1.0;
    const double force = extends ? kPaPerKpa * parameters_.chamber_area_m2
                                 : actuator_.tension_n(0.0, kReferencePressureKpa);
    return {length_m, strength, extends, strength * force, full_pressure_kpa};
  }

  /// Moves what it remembers: call once per step.
  /// @param pressure_kpa  below 0 only where it extends
  double tension_n(const Side& side, double stretch_m, double rate_m_per_s, double pressure_kpa,
                   Memory memory) const {
    const double strain = stretch_m / side.length_m;
    const double bowed_kpa =
        pressure_kpa *
        (1.0 + parameters_.actuator_bow * (1.0 - std::abs(pressure_kpa) / side.full_pressure_kpa));
    const double active = side.extends ? -side.full_force_n_per_kpa * bowed_kpa
                                       : side.strength * actuator_.tension_n(strain, bowed_kpa);
    const double hysteresis =
        braid(side, pressure_kpa).force(stretch_m, rate_m_per_s, memory.braid_anchor_m);
    double creep = 0.0;
    if (parameters_.creep_fraction > 0.0) {
      memory.creep_m += time_step_s_ / parameters_.creep_time_s * (stretch_m - memory.creep_m);
      creep = parameters_.creep_fraction * parameters_.side_elasticity_n *
              (stretch_m - memory.creep_m) / side.length_m;
    }
    return active + elastic_n(side, strain) + creep - hysteresis;
  }

  /// Stored without pressure, that of its braid's spring included.
  double energy_j(const Side& side, double stretch_m, double braid_anchor_m, double creep_m) const {
    const double strain = stretch_m / side.length_m;
    const double relaxing = stretch_m - creep_m;
    const double offset = stretch_m - braid_anchor_m;
    const double actuators =
        side.extends ? 0.0 : side.strength * actuator_.passive_energy_n(strain);
    return side.length_m * (actuators + elastic_energy_n(side, strain)) +
           0.5 * parameters_.creep_fraction * parameters_.side_elasticity_n / side.length_m *
               relaxing * relaxing +
           0.5 * parameters_.hysteresis_stiffness_n_per_m * offset * offset;
  }

 private:
  static constexpr double kPaPerKpa = 1e3;

  // (V7)
  SpringSlider braid(const Side& side, double pressure_kpa) const {
    return {parameters_.hysteresis_stiffness_n_per_m, parameters_.hysteresis_damping_n_s_per_m,
            parameters_.hysteresis_fraction * side.full_force_n_per_kpa * std::abs(pressure_kpa) +
                parameters_.hysteresis_floor_n};
  }

  // A wall that extends stiffens, and is stretched as the surface of (V10) is.
  double elastic_n(const Side& side, double strain) const {
    if (!side.extends) {
      return parameters_.side_elasticity_n * strain;
    }
    const double e = strain / parameters_.actuator_strain_scale;
    return parameters_.side_elasticity_n * e * (1.0 + parameters_.wall_stiffening * e * e);
  }

  double elastic_energy_n(const Side& side, double strain) const {
    const double scale = side.extends ? parameters_.actuator_strain_scale : 1.0;
    const double stiffening = side.extends ? parameters_.wall_stiffening : 0.0;
    const double e = strain / scale;
    return scale * 0.5 * parameters_.side_elasticity_n * e * e * (1.0 + 0.5 * stiffening * e * e);
  }

  VirtualArmParameters parameters_;
  double time_step_s_;
  ActuatorLaw actuator_;
};

}  // namespace limber
