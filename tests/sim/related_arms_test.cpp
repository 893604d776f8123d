#include "limber/sim/related_arms.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr PhysicsFactor kFactor{2.0};

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
  const VirtualArmParameters relative = related_physics(of, PhysicsFactor{1.0}, 3, 7);
  EXPECT_EQ(relative.friction_coefficient, of.friction_coefficient);
  EXPECT_EQ(relative.hinge_damping_n_m_s_per_rad, of.hinge_damping_n_m_s_per_rad);
  EXPECT_NE(relative.strength_seed, of.strength_seed);
}

TEST(RelatedArms, WideReachesTheEndsOfItsRangesAndStaysWithin) {
  const VirtualArmParameters of;
  std::vector<double> friction, payload, tilt, scale, inflate, tip_load;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const VirtualArmParameters p = related_physics(of, WidePhysics{}, 3, k);
    friction.push_back(p.friction_coefficient);
    payload.push_back(p.plate_payload_kg);
    tilt.push_back(p.table_tilt_rad);
    scale.push_back(p.actuator_strain_scale);
    inflate.push_back(p.inflate_time_constant_s);
    tip_load.push_back(p.tip_load_kg);
    EXPECT_EQ(p.strength_spread, 0.25);
    EXPECT_EQ(p.gap_length_spread, 0.03);
    EXPECT_EQ(p.reference_width_m, of.reference_width_m);
  }
  const auto covers = [](const std::vector<double>& values, double low, double high) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    EXPECT_GE(*least, low);
    EXPECT_LE(*most, high);
    EXPECT_GT(*most - *least, 0.95 * (high - low));
  };
  covers(friction, 0.1, 0.45);
  covers(payload, 0.006, 0.024);
  covers(tilt, 0.0, 0.17454);
  covers(scale, 0.75, 1.3);
  covers(inflate, 0.05, 0.25);
  covers(tip_load, 0.0, 0.08);
}

TEST(RelatedArms, WideHoldsTheArmsOwnPhysics) {
  VirtualArmParameters of;
  of.plate_payload_kg = 0.5;
  of.friction_coefficient = 0.0;
  double most_payload = 0.0, least_friction = 1.0;
  for (std::uint64_t k = 0; k < 100; ++k) {
    const VirtualArmParameters p = related_physics(of, WidePhysics{}, 3, k);
    most_payload = std::max(most_payload, p.plate_payload_kg);
    least_friction = std::min(least_friction, p.friction_coefficient);
  }
  EXPECT_GT(most_payload, 0.4);
  EXPECT_LT(least_friction, 0.05);
}

TEST(RelatedArms, VariationsAreFactorsOrWide) {
  EXPECT_TRUE(std::holds_alternative<WidePhysics>(parse_physics_variation("wide")));
  EXPECT_EQ(std::get<PhysicsFactor>(parse_physics_variation("1.5")).factor, 1.5);
  for (const char* wrong : {"0.9", "11", "nan", "", "wider", "1.5x"}) {
    EXPECT_THAT([&] { (void)parse_physics_variation(wrong); },
                ThrowsMessage<InputError>(HasSubstr(std::string("--vary-physics ") + wrong +
                                                    ": expected a factor from 1 to 10, or wide")));
  }
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

TEST(RelatedArms, RecordingsSayWhatWasDrawnForEachEpisode) {
  const ArmDescription arm = sample_arm(2);
  const TemporaryFolder folder;
  ScheduleSettings schedule;
  schedule.kind = ScheduleKind::random;
  schedule.count = 1;
  schedule.episodes = 2;
  schedule.hold_s = 0.1;
  VirtualArmOptions options;
  options.seed = 5;
  const WidePhysics wide;
  CollectionSettings settings = related_collection(arm, schedule, options, wide);
  settings.progress = Progress::Mode::quiet;
  const auto path = folder.path() / "wide.h5";
  (void)collect(arm, settings, related_arm_factory(arm, options, wide), path);
  const Recording recording = read_recording(path);
  EXPECT_THAT(recording.settings, HasSubstr(", varied wide"));
  const VirtualArmParameters of = virtual_arm_parameters(arm);
  for (std::uint64_t k = 0; k < 2; ++k) {
    const std::string& physics = recording.episodes[k].physics;
    EXPECT_EQ(physics, physics_differences(of, related_physics(of, wide, 5, k)));
    EXPECT_THAT(physics, HasSubstr("\"tip_load_kg\": 0.0"));
  }
  EXPECT_NE(recording.episodes[0].physics, recording.episodes[1].physics);
}

}  // namespace
}  // namespace limber
