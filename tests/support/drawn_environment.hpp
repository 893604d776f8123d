#pragma once

// Environments drawn by a number, about an arm.

#include "limber/world/environment.hpp"
#include "planning/random_shapes.hpp"
#include "support/drawn_arm.hpp"

namespace limber {
namespace drawn {

inline Obstacle obstacle(double x, double y, double length, RandomStream& random) {
  switch (random.index(3)) {
    case 0:
      return Circle{x, y, random.uniform(0.01, 0.12) * length};
    case 1:
      return Rectangle{x, y, random.uniform(0.005, 0.3) * length,
                       random.uniform(0.005, 0.3) * length, random.uniform(-4.0, 4.0)};
    default:
      return random_star(x, y, random);
  }
}

inline Environment environment(std::uint64_t number, const ArmDescription& arm,
                               RandomStream& random) {
  Environment environment;
  environment.name = fmt::format("drawn_{}", number);
  const NoLoadModel no_load(arm);
  const double length = arm.length_m();
  if (chance(random, 0.25)) {
    const Pressures kpa =
        chance(random, 0.5) ? pressures(arm, random) : Pressures(0.2F * pressures(arm, random));
    environment.start = ArmStart{kpa, no_load_backbone(no_load, kpa)};
  }
  const Pose tip = tip_pose(no_load_backbone(no_load, pressures(arm, random)));
  environment.goal = {tip.x_m, tip.y_m, std::nullopt, random.uniform(0.01, 0.06) * length,
                      random.uniform(0.05, 0.6)};
  if (chance(random, 0.15)) {  // where the arm may or may not come
    environment.goal.x_m = random.uniform(-1.2, 1.2) * length;
    environment.goal.y_m = random.uniform(-1.2, 1.2) * length;
  }
  if (chance(random, 0.3)) {
    environment.goal.theta_rad =
        tip.theta_rad + (chance(random, 0.2) ? 2.0 * std::numbers::pi : 0.0);
  }
  const int obstacles = int(random.index(6));
  for (int i = 0; i < obstacles; ++i) {
    const double reach = length * std::sqrt(random.uniform(0.05, 1.2));
    const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
    environment.obstacles.push_back(
        obstacle(reach * std::cos(angle), reach * std::sin(angle), length, random));
  }
  return environment;
}

}  // namespace drawn
}  // namespace limber
