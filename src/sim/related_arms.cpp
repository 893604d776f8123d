#include "limber/sim/related_arms.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "limber/common/random_stream.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kPhysicsStream = 0x706879ULL << 32;
constexpr double kLeastStrengthSpread = 0.1;
constexpr std::uint32_t kStrengthSeeds = 1'000'000'000;

// Powers of the factor: how little is known of each.
constexpr double kFriction = 1.0;
constexpr double kMaterial = 0.6;
constexpr double kValves = 0.4;
constexpr double kStrength = 0.2;

}  // namespace

VirtualArmParameters related_physics(const VirtualArmParameters& of, double factor,
                                     std::uint64_t seed, std::uint64_t number) {
  RandomStream random(seed, kPhysicsStream + number);
  VirtualArmParameters physics = of;
  const auto vary = [&](double& value, double power) {
    value *= std::pow(factor, power * random.uniform(-1.0, 1.0));
  };
  vary(physics.friction_coefficient, kFriction);
  vary(physics.plate_payload_kg, kFriction);
  vary(physics.hysteresis_fraction, kFriction);
  vary(physics.side_elasticity_n, kMaterial);
  vary(physics.hinge_stiffness_n_m_per_rad, kMaterial);
  vary(physics.hinge_damping_n_m_s_per_rad, kMaterial);
  vary(physics.friction_stiffness_n_per_m, kMaterial);
  vary(physics.friction_torsion_arm, kMaterial);
  vary(physics.inflate_time_constant_s, kValves);
  vary(physics.vent_time_constant_s, kValves);
  vary(physics.actuator_gain, kStrength);
  physics.strength_spread = std::max(physics.strength_spread, kLeastStrengthSpread);
  physics.strength_seed = random.index(kStrengthSeeds);
  return physics;
}

DriverFactory related_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options,
                                  double factor) {
  return [arm, options, factor](int index) {
    const auto number = static_cast<std::uint64_t>(index);
    ArmDescription relative = arm;
    change_virtual_arm(relative, [&](VirtualArmParameters& physics) {
      physics = related_physics(physics, factor, options.seed, number);
    });
    VirtualArmOptions own = options;
    own.stream = number;
    return std::make_unique<VirtualArm>(relative, own);
  };
}

}  // namespace limber
