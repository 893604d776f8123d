#pragma once

#include <filesystem>

#include "limber/arm/arm_description.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

inline ArmDescription own_space_arm(const char* name) {
  return load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms" /
                  (std::string(name) + ".yaml"));
}

/// One segment of three chambers that extend, all alike, with nothing that remembers or rubs.
inline ArmDescription ideal_segment(int gaps) {
  ArmDescription arm;
  arm.name = "ideal_segment";
  arm.dimension = Dimension::space;
  arm.no_load = NoLoadKind::chambers;
  arm.pressure_rate_limit_kpa_per_s = 200.0;
  arm.actuator_radius_m = 0.004;
  Segment segment;
  segment.length_m = 0.3;
  segment.width_m = 0.05;
  segment.gaps = gaps;
  for (const double angle_deg : {0.0, 120.0, 240.0}) {
    segment.chambers.push_back({angle_deg, 0.02, 1, PressureLimits(0.0, 100.0), {2e-3, 0, 0, 0}});
  }
  arm.segments = {segment};
  VirtualArmParameters physics;
  physics.strength_spread = 0.0;
  physics.hysteresis_fraction = 0.0;
  physics.hysteresis_floor_n = 0.0;
  physics.pressure_dead_band_kpa = 0.0;
  physics.hinge_stiffness_n_m_per_rad = 0.0;
  physics.side_elasticity_n = 200.0;
  physics.chamber_area_m2 = 4e-4;  // 1 kPa is 0.4 N, and strains by 0.002
  physics.plate_mass_kg = 0.2 / gaps;
  physics.plate_mass_fixed_fraction = 1.0;
  physics.plate_payload_kg = 0.0;
  physics.time_step_s = 0.0005;
  set_virtual_arm_parameters(arm, physics);
  return arm;
}

}  // namespace limber
