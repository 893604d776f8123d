#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// The paper's arm, as far as planning needs it.
inline ArmDescription three_segment_arm() {
  ArmDescription arm;
  arm.name = "three_segment";
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  for (const double width : {0.05, 0.03, 0.0172}) {
    arm.segments.push_back({0.235, width, 5, 100.0, {1e-3, 1e-5, 0.0, 0.0}});
  }
  return arm;
}

inline Pressures random_pressures(const ArmDescription& arm, RandomStream& random) {
  Pressures q(arm.segment_count());
  for (int i = 0; i < q.size(); ++i) {
    const double limit = arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa();
    q[i] = static_cast<float>(random.uniform(-limit, limit));
  }
  return q;
}

inline Backbone no_load_backbone(const NoLoadModel& model, const Pressures& q) {
  Backbone b(model.point_count(), 3);
  model.backbone(q, b);
  return b;
}

/// A star-shaped polygon about (x, y): simple whatever the radii, mostly not convex.
inline Polygon random_star(double x, double y, RandomStream& random) {
  Polygon star;
  const int corners = 3 + static_cast<int>(random.index(6));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.0, 0.8)) / corners;
    const double radius = random.uniform(0.02, 0.12);
    star.points_m.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  if (random.uniform() < 0.5) {
    std::reverse(star.points_m.begin(), star.points_m.end());
  }
  return star;
}

inline Obstacle random_obstacle(RandomStream& random) {
  const double x = random.uniform(0.0, 0.75);
  const double y = random.uniform(-0.6, 0.6);
  switch (random.index(3)) {
    case 0:
      return Circle{x, y, random.uniform(0.01, 0.1)};
    case 1:
      return Rectangle{x, y, random.uniform(0.005, 0.3), random.uniform(0.005, 0.3),
                       random.uniform(-4.0, 4.0)};
    default:
      return random_star(x, y, random);
  }
}

}  // namespace limber
