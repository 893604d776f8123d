#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// An arm of n segments whose widths, lengths, gaps and polynomials all differ, so that no test
/// passes by symmetry between segments.
inline ArmDescription arm_of(int segments) {
  ArmDescription arm;
  arm.name = "test_arm_of_" + std::to_string(segments);
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  for (int i = 0; i < segments; ++i) {
    Segment segment;
    segment.length_m = 0.235 - 0.02 * i;
    segment.width_m = 0.05 / (1.0 + 0.4 * i);
    segment.gaps = 3 + i % 3;
    segment.pressure_limit_kpa = 100.0 - 5.0 * i;
    segment.strain_polynomial = {8e-4, 4e-5 - 1e-6 * i, -2e-7, 1e-10};
    arm.segments.push_back(segment);
  }
  return arm;
}

}  // namespace limber
