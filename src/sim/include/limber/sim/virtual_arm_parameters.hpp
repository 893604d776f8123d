#pragma once
// For those who move an arm, real or virtual.

#include <array>
#include <cstdint>
#include <string>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// c1 x + c2 x² + c3 x³ + c4 x⁴; [0] is c1.
using QuarticCoefficients = std::array<double, 4>;

/// Physics of the virtual arm; docs/virtual-arm.md gives each parameter's source and meaning, and
/// says which were fitted. Every one is a key of the arm file's `virtual_arm` mapping. A side is in
/// space a chamber; the table is of arms in a plane alone.
struct VirtualArmParameters {
  // Chain: per gap a slide along the arm and a hinge at its middle. w is the segment's width.
  double slide_damping_n_s_per_m = 2.0;
  double slide_armature_kg = 0.01;
  double hinge_stiffness_n_m_per_rad = 0.02;
  double hinge_damping_n_m_s_per_rad = 0.27;  ///< at the reference width; proportional to w
  double hinge_armature_kg_m2 = 2e-5;
  double reference_width_m = 0.05;         ///< the width that scaled parameters are given at
  double plate_mass_kg = 0.012;            ///< at the reference width
  double plate_mass_fixed_fraction = 0.4;  ///< of it that does not shrink with w
  double plate_payload_kg = 0.012;         ///< added to every plate: fittings, hose, bladder
  double side_elasticity_n = 50.0;         ///< tension per unit strain of a side

  // McKibben actuator: tension [N] over strain e (contraction < 0) and pressure [kPa].
  double actuators_per_side = 2.0;
  QuarticCoefficients actuator_threshold_kpa = {-395.9792747, -1032.874471, 5991.799518,
                                                34610.2847};  ///< p0(e), e < 0
  double actuator_gain = 1.03856;                             ///< N per kPa
  double actuator_strain_offset = 0.511455;
  QuarticCoefficients actuator_extension_n = {62.596, 836.58, 89998.0, 0.0};      ///< e > 0
  QuarticCoefficients actuator_compression_n = {21.928, 126.12, 320.59, 265.30};  ///< e < 0, p < p0
  double actuator_strain_scale = 1.0;  ///< strain over that of the surface above
  double actuator_bow = 0.0;           ///< > 0: more of it at low pressure; none at the limit

  // No two actuators are alike.
  double strength_spread = 0.07;  ///< largest relative deviation of a side's strength
  std::uint64_t strength_seed = 1;
  double hysteresis_fraction = 0.03;  ///< of the side's full tension at its pressure
  double hysteresis_floor_n = 0.05;
  double hysteresis_stiffness_n_per_m = 2e4;
  double hysteresis_damping_n_s_per_m = 0.0;

  // Of arms in space alone.
  double chamber_area_m2 = 3e-4;             ///< effective, of a chamber that extends
  double wall_stiffening = 0.0;              ///< of side_elasticity_n there, × strain²; ≥ 0
  double twist_stiffness_n_m_per_rad = 2.0;  ///< of a gap
  double twist_damping_n_m_s_per_rad = 0.02;
  double joint_friction_n_m = 0.0;  ///< Coulomb's, of a gap's bend and of its twist
  double joint_friction_stiffness_n_m_per_rad = 10.0;
  double joint_friction_damping_n_m_s_per_rad = 0.0;

  // What is worn or added; off while 0.
  double tip_load_kg = 0.0;     ///< on the last plate
  double weak_side_loss = 0.0;  ///< share of its strength that one side of one segment has lost
  int weak_side = 0;            ///< 2 × segment, + 1 for its right side
  double leak_share = 0.0;  ///< of its set point, that one channel's pressure settles short of it
  int leaking_channel = 0;  ///< segment, in space chamber

  // Silicone creep, a spring and dashpot in series beside each side; off while the fraction is 0.
  double creep_fraction = 0.0;  ///< of side_elasticity_n
  double creep_time_s = 20.0;
  // An imperfect build; off while 0.
  double plate_offset_rad = 0.0;       ///< largest unloaded angle of a gap, seeded by strength_seed
  double base_misalignment_rad = 0.0;  ///< angle of the arm's base plate in frame B
  double gap_length_spread = 0.0;      ///< largest relative deviation of a gap, seeded as above

  // Table.
  double gravity_m_per_s2 = 9.81;
  double table_tilt_rad = 0.0;              ///< 0: gravity is normal to the plane
  double table_downhill_rad = 0.0;          ///< direction in frame B that a tilted table falls to
  double friction_coefficient = 0.25;       ///< of sliding
  double friction_static_excess = 0.0;      ///< share by which friction at rest is larger
  double friction_stribeck_m_per_s = 0.02;  ///< speed by which most of the excess is gone
  double friction_viscous_s_per_m = 0.0;    ///< growth of the coefficient with speed
  double friction_stiffness_n_per_m = 3000.0;
  double friction_damping_n_s_per_m = 2.0;
  double friction_torsion_arm = 0.3;  ///< × w

  // Valves and their PD controller.
  double pressure_rate_limit_kpa_per_s = 100.0;  ///< of a direction that has none of its own
  double inflate_rate_limit_kpa_per_s = 0.0;     ///< left out, 0: the one above
  double vent_rate_limit_kpa_per_s = 0.0;        ///< left out, 0: the one above
  double valve_dead_time_s = 0.0;                ///< delay until set points reach the controller
  double inflate_time_constant_s = 0.1;
  double vent_time_constant_s = 0.12;
  double valve_lag_s = 0.01;
  double controller_proportional_gain = 1.0;
  double controller_derivative_gain_s = 0.005;
  double pressure_dead_band_kpa = 0.2;

  double time_step_s = 0.001;
};

/// Of the arm's file; what it leaves out is as above. @throws InputError naming file, line and key,
/// also where a key is of arms in a plane and the arm is in space, or the other way round.
VirtualArmParameters virtual_arm_parameters(const ArmDescription& arm);

/// Puts `parameters` in place of what the arm's file says.
void set_virtual_arm_parameters(ArmDescription& arm, const VirtualArmParameters& parameters);

/// JSON of the parameters that `varied` has other than `of`, one object: {"tip_load_kg": 0.05}.
std::string physics_differences(const VirtualArmParameters& of, const VirtualArmParameters& varied);

/// `of` with what physics_differences wrote. @throws InputError, its message beginning with `where`
VirtualArmParameters with_differences(const VirtualArmParameters& of,
                                      const std::string& differences, Dimension dimension,
                                      const std::string& where);

/// What strength_seed and wear make of one side's strength, 1 of an even one. @param side  2 ×
/// segment, + 1 for its right side; in space the chamber
double side_strength(const VirtualArmParameters& parameters, int side);

/// change(parameters), and puts them back.
template <class Change>
void change_virtual_arm(ArmDescription& arm, Change&& change) {
  VirtualArmParameters parameters = virtual_arm_parameters(arm);
  change(parameters);
  set_virtual_arm_parameters(arm, parameters);
}

/// The arm as YAML with every parameter, also those that its file leaves out.
std::string virtual_arm_to_yaml(const ArmDescription& arm);

/// Hash of what the virtual arm's behaviour depends on: of that, but for `safety`.
std::string virtual_arm_hash(ArmDescription arm);

}  // namespace limber
