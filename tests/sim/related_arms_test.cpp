#include "limber/sim/related_arms.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "limber/sim/virtual_arm_factory.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr double kFactor = 2.0;

TEST(RelatedArms, PhysicsStaysWithinTheFactor) {
  const VirtualArmParameters of;
  double least_friction = 1.0, most_friction = 1.0;
  std::set<std::uint64_t> strength_seeds;
  for (std::uint64_t k = 0; k < 200; ++k) {
    const VirtualArmParameters relative = related_physics(of, kFactor, 3, k);
    const double friction = relative.friction_coefficient / of.friction_coefficient;
    least_friction = std::min(least_friction, friction);
    most_friction = std::max(most_friction, friction);
    EXPECT_LE(std::abs(std::log2(relative.plate_payload_kg / of.plate_payload_kg)), 1.0);
    EXPECT_LE(std::abs(std::log2(relative.actuator_gain / of.actuator_gain)), 0.2 + 1e-12);
    EXPECT_EQ(relative.gravity_m_per_s2, of.gravity_m_per_s2);
    strength_seeds.insert(relative.strength_seed);
  }
  EXPECT_GE(least_friction, 0.5);
  EXPECT_LT(least_friction, 0.55);
  EXPECT_LE(most_friction, 2.0);
  EXPECT_GT(most_friction, 1.8);
  EXPECT_EQ(strength_seeds.size(), 200U);
}

TEST(RelatedArms, FactorOneLeavesAllButTheActuatorsStrengths) {
  const VirtualArmParameters of;
  const VirtualArmParameters relative = related_physics(of, 1.0, 3, 7);
  EXPECT_EQ(relative.friction_coefficient, of.friction_coefficient);
  EXPECT_EQ(relative.hinge_damping_n_m_s_per_rad, of.hinge_damping_n_m_s_per_rad);
  EXPECT_NE(relative.strength_seed, of.strength_seed);
}

/// Where the tip is after the arm was led to 40 kPa in all segments.
Eigen::Vector2d tip_of(const DriverFactory& drivers, int index, const ArmDescription& arm) {
  const std::unique_ptr<ArmDriver> driver = drivers(index);
  const Pressures setpoint_kpa = Pressures::Constant(arm.segment_count(), 40.0F);
  for (int k = 0; k < arm.frames_in(1.5); ++k) {
    driver->command(setpoint_kpa);
  }
  return tip_position_m(*driver->state().backbone);
}

TEST(RelatedArms, EachEpisodeHasAnArmOfItsOwnAndAlwaysTheSame) {
  const ArmDescription arm = sample_arm(2);
  VirtualArmOptions options;
  options.seed = 5;
  const DriverFactory drivers = related_arm_factory(arm, options, kFactor);
  const Eigen::Vector2d first = tip_of(drivers, 0, arm);
  EXPECT_EQ(tip_of(drivers, 0, arm), first);
  EXPECT_GT((tip_of(drivers, 1, arm) - first).norm(), 1e-3);
  EXPECT_GT((tip_of(virtual_arm_factory(arm, options), 0, arm) - first).norm(), 1e-3);
}

}  // namespace
}  // namespace limber
