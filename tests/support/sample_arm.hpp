#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// An arm of n segments that narrows toward its end: the paper's 16 plates for n = 3, otherwise
/// 3, 4, 5, … gaps a segment.
inline ArmDescription sample_arm(int segments) {
  ArmDescription arm;
  arm.name = "sample" + std::to_string(segments);
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  const double widths_m[] = {0.050, 0.030, 0.0172, 0.016, 0.015};
  for (int i = 0; i < segments; ++i) {
    Segment segment;
    segment.length_m = 0.235;
    segment.width_m = widths_m[i % 5];
    segment.gaps = segments == 3 ? 5 : 3 + i;
    segment.pressure_limit_kpa = 100.0;
    segment.strain_polynomial = {1.0e-3, 1.0e-5, 2.0e-8, -1.0e-10};
    arm.segments.push_back(segment);
  }
  return arm;
}

}  // namespace limber
