#pragma once

#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

/// Tension of one McKibben actuator over its strain and pressure: docs/virtual-arm.md, (V3)–(V5).
/// Surface measured by Olson (2019), stretched along its strain. Strain e < 0 is contraction;
/// tension in N, > 0 pulls.
///
/// Threads: constant after construction; share it freely.
class ActuatorLaw {
 public:
  explicit ActuatorLaw(const VirtualArmParameters& parameters)
      : threshold_(parameters.actuator_threshold_kpa),
        extension_(parameters.actuator_extension_n),
        compression_(parameters.actuator_compression_n),
        strain_scale_(parameters.actuator_strain_scale),
        gain_(parameters.actuator_gain),
        offset_(parameters.actuator_strain_offset) {}

  /// (V3) Pressure [kPa] at which the actuator of strain e just pulls.
  double threshold_kpa(double strain) const {
    return surface_threshold_kpa(strain / strain_scale_);
  }

  /// (V4), (V5) Tension; continuous in both arguments. @param pressure_kpa  ≥ 0.
  double tension_n(double strain, double pressure_kpa) const {
    return surface_tension_n(strain / strain_scale_, pressure_kpa);
  }

  /// Work [J per metre of actuator] stored by straining an unpressurised actuator from 0 to e.
  double passive_energy_n(double strain) const {
    return strain_scale_ * surface_energy_n(strain / strain_scale_);
  }

 private:
  // Olson's own surface, of an actuator whose strain scale is 1.
  double surface_threshold_kpa(double strain) const {
    return strain < 0.0 ? quartic(threshold_, strain) : 0.0;
  }

  double surface_tension_n(double strain, double pressure_kpa) const {
    const double threshold = surface_threshold_kpa(strain);
    const double reach = offset_ + strain;
    if (strain >= 0.0) {
      return gain_ * reach * reach * pressure_kpa + quartic(extension_, strain);
    }
    if (pressure_kpa >= threshold) {
      return gain_ * reach * reach * (pressure_kpa - threshold);
    }
    return quartic(compression_, strain) * (1.0 - pressure_kpa / threshold);
  }

  double surface_energy_n(double strain) const {
    const QuarticCoefficients& c = strain < 0.0 ? compression_ : extension_;
    return strain * strain *
           (c[0] / 2 + strain * (c[1] / 3 + strain * (c[2] / 4 + strain * c[3] / 5)));
  }

  static double quartic(const QuarticCoefficients& c, double x) {
    return x * (c[0] + x * (c[1] + x * (c[2] + x * c[3])));
  }

  QuarticCoefficients threshold_;
  QuarticCoefficients extension_;
  QuarticCoefficients compression_;
  double strain_scale_;
  double gain_;
  double offset_;
};

}  // namespace limber
