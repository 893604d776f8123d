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

/// The same driven by motor angles: curvature follows them, to either side by segment.
inline ArmDescription curvature_arm_of(int segments) {
  ArmDescription arm = arm_of(segments);
  arm.command = {"motor angle", "rad"};
  arm.no_load = NoLoadKind::curvature;
  for (int i = 0; i < segments; ++i) {
    Segment& segment = arm.segments[std::size_t(i)];
    segment.pressure_limit_kpa = 1.5;
    segment.curvature_per_unit = i % 2 == 0 ? 4.0 + i : -3.0;
    segment.strain_polynomial = {};
  }
  return arm;
}

}  // namespace limber
