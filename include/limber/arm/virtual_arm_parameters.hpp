#pragma once

#include <cstdint>
#include <string>

namespace limber {

class YamlReader;

/// Physics of the virtual arm (docs/virtual-arm.md), all of them arm-file parameters with their
/// source there. Defaults are the prototype's.
struct VirtualArmParameters {
  // Chain: per gap a slide along the arm and a hinge at its middle. w is the segment's width.
  double slide_damping_n_s_per_m = 2.0;
  double slide_armature_kg = 0.01;
  double hinge_stiffness_n_m_per_rad = 0.02;
  double hinge_damping_n_m_s_per_rad = 0.15;  ///< at w = 0.05 m; proportional to w
  double hinge_armature_kg_m2 = 2e-5;
  double plate_mass_kg = 0.012;     ///< × (0.4 + 0.6 w/0.05)
  double plate_payload_kg = 0.024;  ///< added to every plate: fittings, hose, bladder
  double side_elasticity_n = 50.0;  ///< N per unit strain of a side

  // No two actuators are alike.
  double strength_spread = 0.07;  ///< largest relative deviation of a side's strength
  std::uint64_t strength_seed = 1;
  double hysteresis_fraction = 0.03;  ///< of the side's full tension at that pressure
  double hysteresis_floor_n = 0.05;
  double hysteresis_stiffness_n_per_m = 2e4;

  // Table.
  double friction_coefficient = 0.2;
  double friction_stiffness_n_per_m = 3000.0;
  double friction_damping_n_s_per_m = 2.0;
  double friction_torsion_arm = 0.3;  ///< × w

  // Valves and their PD controller.
  double pressure_rate_limit_kpa_per_s = 100.0;
  double inflate_time_constant_s = 0.1;
  double vent_time_constant_s = 0.12;
  double pressure_dead_band_kpa = 0.2;

  double time_step_s = 0.001;
};

VirtualArmParameters read_virtual_arm_parameters(const YamlReader& node);
std::string virtual_arm_parameters_to_yaml(const VirtualArmParameters& parameters, int indent);

}  // namespace limber
