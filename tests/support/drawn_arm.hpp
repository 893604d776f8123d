#pragma once

// Arms drawn by a number, for laws that hold for every arm.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace drawn {

inline bool chance(RandomStream& random, double share) {
  return random.uniform() < share;
}

/// 1 to 8 segments; no gap turns by more than half a turn. Written and read again, as users' are.
inline ArmDescription arm(std::uint64_t number, RandomStream& random) {
  ArmDescription arm;
  arm.name = fmt::format("drawn_{}", number);
  arm.frame_rate_hz = 10.0 + random.index(31);
  arm.pressure_rate_limit_kpa_per_s = random.uniform(60.0, 400.0);
  arm.actuator_radius_m = chance(random, 0.5) ? random.uniform(0.0, 0.01) : 0.0;
  const bool bends_by_command = chance(random, 0.2);
  if (bends_by_command) {
    arm.no_load = NoLoadKind::curvature;
    arm.command = {"tendon", "mm"};
  }
  const int segments = 1 + int(random.index(8));
  for (int i = 0; i < segments; ++i) {
    Segment segment{random.uniform(0.08, 0.3), random.uniform(0.015, 0.06),
                    1 + int(random.index(5)), random.uniform(40.0, 150.0)};
    if (chance(random, 0.3)) {
      segment.pressure_limit_kpa = {chance(random, 0.3) ? 0.0 : -random.uniform(20.0, 120.0),
                                    random.uniform(20.0, 120.0)};
    }
    const double limit = segment.pressure_limit_kpa.largest_kpa();
    const double max_turn_rad = std::min(2.5 * segment.gaps, random.uniform(0.5, 4.0));
    if (bends_by_command) {
      segment.curvature_per_unit =
          (chance(random, 0.5) ? 1.0 : -1.0) * max_turn_rad / (segment.length_m * limit);
    } else {
      const double full =
          std::min(random.uniform(0.05, 0.4), max_turn_rad * segment.width_m / segment.length_m);
      const double linear = random.uniform(0.1, 1.0);
      segment.strain_polynomial = {linear * full / limit, (1.0 - linear) * full / (limit * limit),
                                   0.0, 0.0};
    }
    arm.segments.push_back(segment);
  }
  return read_arm(YamlReader::from_text(arm_to_yaml(arm), "drawn.yaml"));
}

inline Pressures pressures(const ArmDescription& arm, RandomStream& random) {
  Pressures kpa(arm.channel_count());
  for (Eigen::Index i = 0; i < kpa.size(); ++i) {
    const PressureLimits& limit = arm.limits_of_channel(int(i));
    kpa[i] = static_cast<float>(
        limit.clamped(random.uniform(0.9 * limit.lower_kpa, 0.9 * limit.upper_kpa)));
  }
  return kpa;
}

/// In space: 1 to 4 segments of 3 or 4 chambers, each of which extends or contracts.
inline ArmDescription space_arm(std::uint64_t number, RandomStream& random) {
  ArmDescription arm;
  arm.name = fmt::format("drawn_in_space_{}", number);
  arm.dimension = Dimension::space;
  arm.no_load = NoLoadKind::chambers;
  arm.frame_rate_hz = 10.0 + random.index(31);
  arm.pressure_rate_limit_kpa_per_s = random.uniform(60.0, 400.0);
  const int segments = 1 + int(random.index(4));
  for (int i = 0; i < segments; ++i) {
    Segment segment{random.uniform(0.08, 0.3), random.uniform(0.03, 0.08), 1 + int(random.index(5)),
                    100.0};
    const int chambers = 3 + int(random.index(2));
    const double first_deg = random.uniform(0.0, 90.0);
    for (int k = 0; k < chambers; ++k) {
      Chamber chamber{first_deg + 360.0 * k / chambers, random.uniform(0.2, 0.5) * segment.width_m,
                      chance(random, 0.5) ? 1 : -1,
                      PressureLimits(0.0, random.uniform(50.0, 150.0))};
      const double full = random.uniform(0.02, 0.2);
      chamber.strain_polynomial = {full / chamber.limit_kpa.upper_kpa, 0.0, 0.0, 0.0};
      segment.chambers.push_back(chamber);
    }
    arm.segments.push_back(segment);
  }
  return read_arm(YamlReader::from_text(arm_to_yaml(arm), "drawn.yaml"));
}

}  // namespace drawn
}  // namespace limber
