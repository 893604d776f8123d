#include "limber/sim/disturbance.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/mjcf.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/bending_plan.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::uint64_t kSeed = 5;

class DisturbanceTest : public ::testing::Test {
 protected:
  DisturbedArm with(const std::string& text, std::uint64_t seed = kSeed) const {
    return disturbed(arm_, plan_, parse_disturbances(text), seed);
  }
  VirtualArmParameters parameters(const std::string& text, std::uint64_t seed = kSeed) const {
    return virtual_arm_parameters(with(text, seed).arm);
  }
  /// Tip after 80 kPa in both segments for 6 s.
  Eigen::Vector2d settled_tip(const DisturbedArm& met) const {
    VirtualArm driver(met.arm, met.options);
    driver.settle(Pressures::Constant(2, 80.0F), 6.0);
    return tip_position_m(driver.true_backbone());
  }

  const ArmDescription arm_ = sample_arm(2);
  const Environment environment_{};
  const Plan plan_ = bending_plan(arm_, environment_);
};

TEST_F(DisturbanceTest, NoneIsTheArmAsItIsToTheBit) {
  const DisturbedArm met = with("");
  EXPECT_EQ(virtual_arm_to_yaml(met.arm), virtual_arm_to_yaml(arm_));
  EXPECT_FALSE(met.obstacle);
  VirtualArm driver(met.arm, met.options);
  VirtualArm plain(arm_);
  for (int k = 0; k < 40; ++k) {
    const Pressures setpoint_kpa = Pressures::Constant(2, 2.0F * float(k));
    EXPECT_EQ(*driver.command(setpoint_kpa).backbone, *plain.command(setpoint_kpa).backbone);
    EXPECT_EQ(driver.state().pressure_kpa, plain.state().pressure_kpa);
  }
}

TEST_F(DisturbanceTest, ATipLoadIsMassOnTheLastPlateAndShiftsWhereTheArmSettles) {
  const auto links = chain_links(arm_, virtual_arm_parameters(arm_));
  const DisturbedArm met = with("tip_load=0.1");
  const auto loaded = chain_links(met.arm, virtual_arm_parameters(met.arm));
  ASSERT_EQ(links.size(), loaded.size());
  for (std::size_t i = 0; i + 1 < links.size(); ++i) {
    EXPECT_EQ(links[i].mass_kg, loaded[i].mass_kg);
  }
  EXPECT_DOUBLE_EQ(loaded.back().mass_kg, links.back().mass_kg + 0.1);
  constexpr double kNoticed_m = 0.001;
  EXPECT_GT((settled_tip(met) - settled_tip(with(""))).norm(), kNoticed_m);
}

TEST_F(DisturbanceTest, FrictionGrowsByItsShareUnderPlatesAndInBraids) {
  const VirtualArmParameters before = virtual_arm_parameters(arm_);
  const VirtualArmParameters after = parameters("friction");
  EXPECT_DOUBLE_EQ(after.friction_coefficient, 1.3 * before.friction_coefficient);
  EXPECT_DOUBLE_EQ(after.hysteresis_fraction, 1.3 * before.hysteresis_fraction);
  EXPECT_DOUBLE_EQ(after.hysteresis_floor_n, 1.3 * before.hysteresis_floor_n);
  EXPECT_EQ(after.hinge_damping_n_m_s_per_rad, before.hinge_damping_n_m_s_per_rad);
}

TEST_F(DisturbanceTest, AWeakSideContractsLessUnderItsPressureAndItsSeedDrawsIt) {
  std::vector<int> sides(4, 0);
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    ++sides.at(static_cast<std::size_t>(parameters("weak_actuator", seed).weak_side));
  }
  EXPECT_THAT(sides, ::testing::Each(::testing::Gt(0)));
  EXPECT_DOUBLE_EQ(parameters("weak_actuator").weak_side_loss, 0.2);

  const auto contraction = [&](int weak_side, float kpa) {
    ArmDescription arm = arm_;
    change_virtual_arm(arm, [&](auto& p) {
      p.weak_side = weak_side;
      p.weak_side_loss = 0.2;
    });
    VirtualArm driver(arm);
    driver.settle(Pressures::Unit(2, 0) * kpa, 4.0);
    return kpa > 0.0F ? -driver.right_strain(0) : -driver.left_strain(0);
  };
  constexpr int kElsewhere = 3;
  EXPECT_LT(contraction(1, 60.0F), contraction(kElsewhere, 60.0F)) << "right";
  EXPECT_LT(contraction(0, -60.0F), contraction(kElsewhere, -60.0F)) << "left";
}

TEST_F(DisturbanceTest, ASideThatTheArmHasNotIsRefused) {
  ArmDescription arm = arm_;
  change_virtual_arm(arm, [](auto& p) {
    p.weak_side = 4;
    p.weak_side_loss = 0.1;
  });
  EXPECT_THAT([&] { VirtualArm{arm}; },
              ThrowsMessage<InputError>(AllOf(HasSubstr("weak_side = 4"), HasSubstr("0 to 3"))));
}

TEST_F(DisturbanceTest, NoiseComesExactlyTwoFramesLate) {
  const DisturbedArm met = with("noise=1e-12");  // next to none: the delay alone
  constexpr double kRounding_m = 1e-6;
  VirtualArm driver(met.arm, met.options);
  std::vector<Backbone> truth{driver.true_backbone().cast<float>()};
  for (int k = 1; k <= 20; ++k) {
    driver.command(Pressures::Constant(2, 5.0F * float(k)));
    truth.push_back(driver.true_backbone().cast<float>());
    const Backbone& then = truth[static_cast<std::size_t>(std::max(k - 2, 0))];
    EXPECT_LT((*driver.state().backbone - then).cwiseAbs().maxCoeff(), kRounding_m) << k;
  }
}

TEST_F(DisturbanceTest, NoiseHasItsDeviation) {
  const struct {
    const char* kinds;
    double latency_s;
    double deviation_m;
  } cases[] = {{"noise", 0.1, 5e-4},
               {"sensor_noise", 0.0, 5e-4},
               {"noise=0.0003,sensor_noise=0.0004", 0.1, 5e-4}};  // independent, so squares add
  for (const auto& [kinds, latency_s, deviation_m] : cases) {
    const DisturbedArm met = with(kinds);
    EXPECT_EQ(met.options.latency_s, latency_s) << kinds;
    VirtualArm driver(met.arm, met.options);
    const Backbone rest = VirtualArm(arm_).true_backbone().cast<float>();
    double sum = 0.0;
    constexpr int kFrames = 400;
    for (int k = 0; k < kFrames; ++k) {
      driver.command(Pressures::Zero(2));
      sum += double((*driver.state().backbone - rest).leftCols<2>().squaredNorm());
    }
    const double measured_m = std::sqrt(sum / (2.0 * kFrames * double(rest.rows())));
    EXPECT_NEAR(measured_m, deviation_m, 0.05 * deviation_m) << kinds;
  }
}

TEST_F(DisturbanceTest, ALoadIsPickedUpByTheArmAsTheOtherKindsHaveIt) {
  const DisturbedArm met = with("picked_up=0.02,friction");
  ASSERT_TRUE(met.options.later);
  const VirtualArmParameters before = virtual_arm_parameters(met.arm);
  const VirtualArmParameters after = virtual_arm_parameters(*met.options.later);
  EXPECT_EQ(before.tip_load_kg, virtual_arm_parameters(arm_).tip_load_kg);
  EXPECT_NEAR(after.tip_load_kg - before.tip_load_kg, 0.02, 1e-12);
  EXPECT_EQ(after.friction_coefficient, before.friction_coefficient);
  EXPECT_GT(met.options.later_from_s, 0.0);
}

TEST_F(DisturbanceTest, ALeakTakesItsShareOfTheSetPointFromOneSegment) {
  std::vector<int> segments(2, 0);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const DisturbedArm met = with("leak", kSeed + seed);
    ASSERT_TRUE(met.options.later);
    ++segments.at(
        static_cast<std::size_t>(virtual_arm_parameters(*met.options.later).leaking_channel));
  }
  EXPECT_THAT(segments, ::testing::Each(::testing::Gt(0)));

  const DisturbedArm met = with("leak=0.2");
  const VirtualArmParameters after = virtual_arm_parameters(*met.options.later);
  VirtualArm driver(met.arm, met.options);
  driver.settle(Pressures::Constant(2, 40.0F), met.options.later_from_s + 4.0);
  const Pressures settled_kpa = driver.state().pressure_kpa;
  const auto other = static_cast<Eigen::Index>(1 - after.leaking_channel);
  EXPECT_NEAR(settled_kpa[1 - other], 0.8 * 40.0, 2.0 * after.pressure_dead_band_kpa);
  EXPECT_NEAR(settled_kpa[other], 40.0, after.pressure_dead_band_kpa);
}

TEST_F(DisturbanceTest, WhatChangesInMidPlanChangesAtOneMomentAndNothingElse) {
  const DisturbedArm one = with("picked_up,leak");
  const DisturbedArm other = with("leak,picked_up");
  EXPECT_EQ(one.options.later_from_s, other.options.later_from_s);
  EXPECT_EQ(virtual_arm_to_yaml(*one.options.later), virtual_arm_to_yaml(*other.options.later));
  ArmDescription leaking = arm_;
  change_virtual_arm(leaking, [](auto& p) { p.leak_share = 0.2; });
  const DisturbedArm met = disturbed(leaking, plan_, parse_disturbances("picked_up"), kSeed);
  EXPECT_EQ(virtual_arm_parameters(*met.options.later).leak_share, 0.2) << "that it had before";
}

TEST_F(DisturbanceTest, ASegmentThatTheArmHasNotDoesNotLeak) {
  ArmDescription arm = arm_;
  change_virtual_arm(arm, [](auto& p) {
    p.leaking_channel = 2;
    p.leak_share = 0.1;
  });
  EXPECT_THAT([&] { VirtualArm{arm}; },
              ThrowsMessage<InputError>(HasSubstr("leaking_channel = 2")));
}

TEST_F(DisturbanceTest, TrackingIsLostOnceForAsLongAsSaid) {
  const DisturbedArm met = with("lost_tracking");
  const double moves_s = (plan_.frame_count() - 1) * arm_.frame_period_s();
  EXPECT_LE(met.options.lost_from_s + 0.5, moves_s);
  EXPECT_NE(met.options.lost_from_s, with("lost_tracking", kSeed + 1).options.lost_from_s);
  VirtualArm driver(met.arm, met.options);
  std::string tracked;
  for (int k = 0; k < arm_.frames_in(moves_s); ++k) {
    tracked += driver.command(Pressures::Zero(2)).backbone ? '+' : '.';
  }
  const std::size_t from = tracked.find('.');
  ASSERT_NE(from, std::string::npos);
  EXPECT_EQ(tracked.find_last_of('.') - from + 1, 10U) << tracked;
  EXPECT_EQ(std::count(tracked.begin(), tracked.end(), '.'), 10) << tracked;
}

TEST_F(DisturbanceTest, SeedsRepeatAndKindsDoNotDisturbEachOther) {
  const DisturbedArm alone = with("lost_tracking");
  const DisturbedArm both = with("weak_actuator,lost_tracking,friction=0.5");
  EXPECT_EQ(alone.options.lost_from_s, both.options.lost_from_s);
  EXPECT_EQ(virtual_arm_parameters(both.arm).weak_side, parameters("weak_actuator").weak_side);
  EXPECT_EQ(virtual_arm_to_yaml(both.arm),
            virtual_arm_to_yaml(with("weak_actuator,lost_tracking,friction=0.5").arm));
}

TEST_F(DisturbanceTest, TextIsReadAsWritten) {
  for (const char* text : {"", "friction", "tip_load=0.1,noise", "obstacle=0.03"}) {
    EXPECT_EQ(to_string(parse_disturbances(text)), text);
  }
  EXPECT_EQ(to_string(parse_disturbances("friction=0.3")), "friction") << "the usual amount";
}

TEST_F(DisturbanceTest, WhatIsWrongIsNamed) {
  const auto refuses = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { (void)parse_disturbances(text); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refuses("wind", "disturbance 'wind': no such kind; expected tip_load[=0.05] (kg)");
  refuses("friction,", "disturbance ''");
  refuses("friction=-1", "friction=-1: expected a number above 0, at most 10");
  refuses("noise=nan", "noise=nan: expected a number");
  refuses("noise=1e-3x", "noise=1e-3x: expected a number");
  refuses("noise,noise", "noise twice");
}

}  // namespace
}  // namespace limber
