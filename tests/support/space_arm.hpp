#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber::testing_support {

/// Two segments of three extending chambers each, three gaps and two, that hang.
inline constexpr const char* kSpaceArm = R"(schema: limber/arm/1
name: hanging
dimension: 3
no_load: chambers
frame_rate_hz: 20
pressure_rate_limit_kpa_per_s: 200
actuator_radius_m: 0.004
gravity: [1, 0, 0]
segments:
  - {length_m: 0.18, width_m: 0.06, gaps: 3, chambers: [
      {angle_deg: 0, radius_m: 0.02, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.002, 1e-5, 0, 0]},
      {angle_deg: 120, radius_m: 0.02, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.002, 1e-5, 0, 0]},
      {angle_deg: 240, radius_m: 0.02, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.002, 1e-5, 0, 0]}]}
  - {length_m: 0.16, width_m: 0.05, gaps: 2, chambers: [
      {angle_deg: 60, radius_m: 0.018, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.0018, 0, 0, 0]},
      {angle_deg: 180, radius_m: 0.018, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.0018, 0, 0, 0]},
      {angle_deg: 300, radius_m: 0.018, sense: extending, pressure_limit_kpa: [0, 100],
       strain_polynomial: [0.0018, 0, 0, 0]}]}
)";

inline ArmDescription space_arm(const std::string& text = kSpaceArm) {
  return read_arm(YamlReader::from_text(text, "space.yaml"));
}

}  // namespace limber::testing_support
