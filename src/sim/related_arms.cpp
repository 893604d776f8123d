#include "limber/sim/related_arms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/units.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

using Parameters = VirtualArmParameters;

constexpr std::uint64_t kPhysicsStream = 0x706879ULL << 32;
constexpr std::uint32_t kStrengthSeeds = 1'000'000'000;
constexpr const char* kWide = "wide";

// Powers of the factor: how little is known of each.
constexpr double kFriction = 1.0;
constexpr double kMaterial = 0.6;
constexpr double kValves = 0.4;
constexpr double kStrength = 0.2;
constexpr double kLeastStrengthSpread = 0.1;

/// One parameter of the wide family, whatever the arm's file says; reasons:
/// docs/log/2026-11-28-virtual-arm.md.
struct Range {
  double Parameters::*member;
  double low;
  double high;
  bool by_logarithm = false;
};

constexpr std::array kWideRanges = {
    Range{&Parameters::friction_coefficient, 0.1, 0.45},
    Range{&Parameters::friction_static_excess, 0.0, 0.4},
    Range{&Parameters::friction_stribeck_m_per_s, 0.01, 0.1, true},
    Range{&Parameters::friction_viscous_s_per_m, 0.0, 0.2},
    Range{&Parameters::table_tilt_rad, 0.0, 10.0 * kRadPerDeg},
    Range{&Parameters::table_downhill_rad, -std::numbers::pi, std::numbers::pi},
    Range{&Parameters::tip_load_kg, 0.0, 0.08},
    Range{&Parameters::plate_payload_kg, 0.006, 0.024, true},
    Range{&Parameters::actuator_strain_scale, 0.75, 1.3},
    Range{&Parameters::actuator_bow, -0.4, 0.4},
    Range{&Parameters::inflate_time_constant_s, 0.05, 0.25, true},
    Range{&Parameters::vent_time_constant_s, 0.05, 0.25, true},
    Range{&Parameters::valve_dead_time_s, 0.0, 0.05},
    Range{&Parameters::creep_fraction, 0.0, 0.15},
    Range{&Parameters::hysteresis_fraction, 0.0, 0.08},
};
constexpr double kWideGain = 0.1;             // ± share, of all actuators alike
constexpr double kWideStrengthSpread = 0.25;  // of each side
constexpr double kWideGapLengthSpread = 0.03;
constexpr double kWideMaterialFactor = 1.5;  // as the small family's

void multiply(double& value, double factor, double power, RandomStream& random) {
  value *= std::pow(factor, power * random.uniform(-1.0, 1.0));
}

/// Of an arm in space; table and plane have no place in it.
constexpr std::array kWideRangesInSpace = {
    Range{&Parameters::tip_load_kg, 0.0, 0.08},
    Range{&Parameters::actuator_strain_scale, 0.75, 1.3},
    Range{&Parameters::actuator_bow, -0.4, 0.4},
    Range{&Parameters::inflate_time_constant_s, 0.05, 0.25, true},
    Range{&Parameters::vent_time_constant_s, 0.05, 0.25, true},
    Range{&Parameters::valve_dead_time_s, 0.0, 0.2},
    Range{&Parameters::creep_fraction, 0.0, 0.15},
    Range{&Parameters::hysteresis_fraction, 0.0, 0.08},
};
constexpr double kWideFactorInSpace =
    2.0;  // of joint friction and payload, whatever the arm's size

/// In this order, each from a number of its own.
void multiply_each(Parameters& physics, double factor, double power,
                   std::initializer_list<double Parameters::*> members, RandomStream& random) {
  for (double Parameters::*const member : members) {
    multiply(physics.*member, factor, power, random);
  }
}

void multiply_materials(Parameters& physics, double factor, bool in_space, RandomStream& random) {
  multiply_each(physics, factor, kMaterial,
                {&Parameters::side_elasticity_n, &Parameters::hinge_stiffness_n_m_per_rad,
                 &Parameters::hinge_damping_n_m_s_per_rad},
                random);
  if (in_space) {
    multiply(physics.twist_stiffness_n_m_per_rad, factor, kMaterial, random);
  } else {
    multiply_each(physics, factor, kMaterial,
                  {&Parameters::friction_stiffness_n_per_m, &Parameters::friction_torsion_arm},
                  random);
  }
}

void draw(Parameters& physics, const PhysicsFactor& of, bool in_space, RandomStream& random) {
  multiply_each(physics, of.factor, kFriction,
                {in_space ? &Parameters::joint_friction_n_m : &Parameters::friction_coefficient,
                 &Parameters::plate_payload_kg, &Parameters::hysteresis_fraction},
                random);
  multiply_materials(physics, of.factor, in_space, random);
  multiply_each(physics, of.factor, kValves,
                {&Parameters::inflate_time_constant_s, &Parameters::vent_time_constant_s}, random);
  multiply(physics.actuator_gain, of.factor, kStrength, random);
  if (in_space) {
    multiply_each(physics, of.factor, kStrength,
                  {&Parameters::chamber_area_m2, &Parameters::actuator_strain_scale}, random);
  }
  physics.strength_spread = std::max(physics.strength_spread, kLeastStrengthSpread);
}

/// Ranges are widened to hold the arm file's own value.
void draw_ranges(Parameters& physics, std::span<const Range> ranges, RandomStream& random) {
  for (const Range& range : ranges) {
    double& value = physics.*(range.member);
    const double low = std::min(range.low, value);
    const double high = std::max(range.high, value);
    value = range.by_logarithm && low > 0.0
                ? std::exp(random.uniform(std::log(low), std::log(high)))
                : random.uniform(low, high);
  }
}

void draw(Parameters& physics, const WidePhysics&, bool in_space, RandomStream& random) {
  if (in_space) {
    draw_ranges(physics, kWideRangesInSpace, random);
    multiply(physics.joint_friction_n_m, kWideFactorInSpace, kFriction, random);
    multiply(physics.plate_payload_kg, kWideFactorInSpace, kFriction, random);
  } else {
    draw_ranges(physics, kWideRanges, random);
  }
  multiply_materials(physics, kWideMaterialFactor, in_space, random);
  physics.actuator_gain *= 1.0 + random.uniform(-kWideGain, kWideGain);
  if (in_space) {
    physics.chamber_area_m2 *= 1.0 + random.uniform(-kWideGain, kWideGain);
  }
  physics.strength_spread = std::max(physics.strength_spread, kWideStrengthSpread);
  physics.gap_length_spread = std::max(physics.gap_length_spread, kWideGapLengthSpread);
}

}  // namespace

PhysicsVariation parse_physics_variation(const std::string& text) {
  if (text == kWide) {
    return WidePhysics{};
  }
  const std::optional<double> factor = number_in(text);
  if (!(factor >= 1.0 && factor <= kMaxPhysicsFactor)) {
    throw InputError(fmt::format("--vary-physics {}: expected a factor from 1 to {}, or {}",
                                 printable(text), kMaxPhysicsFactor, kWide));
  }
  return PhysicsFactor{*factor};
}

std::string describe(const PhysicsVariation& variation) {
  const auto* by = std::get_if<PhysicsFactor>(&variation);
  return by == nullptr ? kWide : fmt::format("by up to {}", by->factor);
}

VirtualArmParameters related_physics(const VirtualArmParameters& of,
                                     const PhysicsVariation& variation, std::uint64_t seed,
                                     std::uint64_t number, Dimension dimension) {
  RandomStream random(seed, kPhysicsStream + number);
  VirtualArmParameters physics = of;
  const bool in_space = dimension == Dimension::space;
  std::visit([&](const auto& how) { draw(physics, how, in_space, random); }, variation);
  physics.strength_seed = random.index(kStrengthSeeds);
  return physics;
}

ArmDescription with_related_physics(const ArmDescription& arm, const PhysicsVariation& variation,
                                    std::uint64_t seed, std::uint64_t number) {
  ArmDescription relative = arm;
  change_virtual_arm(relative, [&](VirtualArmParameters& physics) {
    physics = related_physics(physics, variation, seed, number, arm.dimension);
  });
  return relative;
}

DriverFactory related_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options,
                                  const PhysicsVariation& variation) {
  return [arm, options, variation](int index) {
    const auto number = std::uint64_t(index);
    const ArmDescription relative = with_related_physics(arm, variation, options.seed, number);
    return virtual_arm_factory(relative, options)(index);
  };
}

CollectionSettings related_collection(const ArmDescription& arm, const ScheduleSettings& schedule,
                                      const VirtualArmOptions& options,
                                      const PhysicsVariation& variation) {
  CollectionSettings settings = virtual_collection(arm, schedule, options);
  settings.driver += fmt::format(", varied {}", describe(variation));
  settings.physics = [of = virtual_arm_parameters(arm), variation, seed = options.seed,
                      dimension = arm.dimension](int index) {
    const auto number = std::uint64_t(index);
    return physics_differences(of, related_physics(of, variation, seed, number, dimension));
  };
  return settings;
}

}  // namespace limber
