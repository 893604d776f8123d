#pragma once
// For those who prepare a network for an arm whose physics is not known.

#include <cstdint>
#include <string>
#include <variant>

#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

inline constexpr double kMaxPhysicsFactor = 10.0;

/// What is seldom known of an arm is drawn again, evenly in its logarithm. Friction on the table
/// and in the braid, and payload, are up to `factor` times more or less; elasticity, stiffness and
/// damping up to its power 0.6; valves 0.4; strength 0.2. In space joints stand for the table, and
/// the strain of actuators, 0.2, varies too.
struct PhysicsFactor {
  double factor = 1.0;  ///< 1 to kMaxPhysicsFactor
};
/// Drawn from what arms, tables and valves are like (docs/virtual-arm.md, "The wide family").
struct WidePhysics {};
/// In both, each actuator has another strength than in the arm's file.
using PhysicsVariation = std::variant<PhysicsFactor, WidePhysics>;

/// A factor, or "wide". @throws InputError if `text` is neither.
PhysicsVariation parse_physics_variation(const std::string& text);

/// "wide", or "by up to 1.5".
std::string describe(const PhysicsVariation& variation);

/// Physics of a related arm. @param number  of the relative among those of `seed`
VirtualArmParameters related_physics(const VirtualArmParameters& of,
                                     const PhysicsVariation& variation, std::uint64_t seed,
                                     std::uint64_t number, Dimension dimension = Dimension::plane);

/// `arm` with that physics among its virtual arm's parameters.
ArmDescription with_related_physics(const ArmDescription& arm, const PhysicsVariation& variation,
                                    std::uint64_t seed, std::uint64_t number);

/// A virtual arm of other physics for each episode; its dimensions are those of `arm`.
DriverFactory related_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options,
                                  const PhysicsVariation& variation);

/// As virtual_collection, for arms of related_arm_factory; each episode says what its arm's
/// physics is (Episode::physics).
CollectionSettings related_collection(const ArmDescription& arm, const ScheduleSettings& schedule,
                                      const VirtualArmOptions& options,
                                      const PhysicsVariation& variation);

}  // namespace limber
