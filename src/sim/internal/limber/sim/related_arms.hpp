#pragma once
// For those who prepare a network for an arm whose physics is not known.

#include <cstdint>

#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

inline constexpr double kMaxPhysicsFactor = 10.0;

/// Physics of a related arm: what is seldom known of an arm is drawn again, evenly in its
/// logarithm. Friction on the table and in the braid, and payload, are up to `factor` times more or
/// less; elasticity, stiffness and damping up to its power 0.6; valves 0.4; strength 0.2. Each
/// actuator has another strength than in `of`.
/// @param factor  1 to kMaxPhysicsFactor
/// @param number  of the relative among those of `seed`
VirtualArmParameters related_physics(const VirtualArmParameters& of, double factor,
                                     std::uint64_t seed, std::uint64_t number);

/// A virtual arm of other physics for each episode; its dimensions are those of `arm`.
DriverFactory related_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options,
                                  double factor);

}  // namespace limber
