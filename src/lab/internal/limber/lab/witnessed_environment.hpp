#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limber/lab/witness.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// An environment about one motion of an arm, and the set points of that motion.
struct WitnessedEnvironment {
  Environment environment;
  double clearance_m = 0.0;              ///< that every obstacle keeps from every shape, at least
  std::vector<Pressures> waypoints_kpa;  ///< where the motion goes from rest, one after another
};

/// A random environment that no planner and no model has chosen (docs/environments.md). The witness
/// moves from rest by one to three straight motions, and the goal is where its tip ends. 5 to 13
/// obstacles lie within 16 cm of its shapes, and 1.2 or 2 cm clear of all of them, and of what is
/// between them. Lengths are for the paper's arm, and grow with others. Depends on its arguments
/// alone.
/// @param number  of the environment among those of `seed`; part of its name
/// @return none for an arm whose tip stays where it is in a hundred motions
std::optional<WitnessedEnvironment> witnessed_environment(const ArmDescription& arm,
                                                          const Witness& witness,
                                                          std::uint64_t seed, std::uint64_t number);

}  // namespace limber
