#pragma once

#include <string>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

/// An arm file of one segment.
inline constexpr const char* kGood = R"(schema: limber/arm/1
name: small
frame_rate_hz: 20
pressure_rate_limit_kpa_per_s: 100
actuator_radius_m: 0.006
segments:
  - length_m: 0.2
    width_m: 0.05
    gaps: 4
    pressure_limit_kpa: 80
    strain_polynomial: [1.0e-3, 1.0e-5, 0, 0]
virtual_arm:
  friction_coefficient: 0.2
  strength_seed: 3
)";

inline ArmDescription read(const std::string& text) {
  return read_arm(YamlReader::from_text(text, "a.yaml"));
}

/// kGood with one piece replaced; the piece must be there.
inline std::string with(const std::string& piece, const std::string& replacement) {
  std::string text = kGood;
  const std::size_t place = text.find(piece);
  EXPECT_NE(place, std::string::npos) << piece;
  return text.replace(place, piece.size(), replacement);
}

}  // namespace limber
