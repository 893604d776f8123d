#include "limber/arm/valve_model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "random_valves.hpp"
#include "support/allocation_count.hpp"
#include "test_arms.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kExactKpa = 1e-9;      // closed forms in double precision
constexpr double kFloatKpa = 2e-5;      // float at 100 kPa
constexpr double kFloatWalkKpa = 1e-3;  // float against double over long walks

ArmDescription one_segment(double frame_rate_hz = 20.0) {
  ArmDescription arm = arm_of(1);
  arm.frame_rate_hz = frame_rate_hz;
  return arm;
}

/// Pressures of one segment after every frame at constant set point, from `start`.
std::vector<double> at_constant(const SegmentValves& valves, double start, double setpoint,
                                int frames, bool has_sides = true, double rate_hz = 20.0) {
  ArmDescription arm = has_sides ? one_segment(rate_hz) : curvature_arm_of(1);
  const ValveModel model(arm, same(1, valves, has_sides));
  const Eigen::MatrixXd result = model.run(Eigen::MatrixXd::Constant(1, frames + 1, setpoint),
                                           Eigen::VectorXd::Constant(1, start));
  return {result.data(), result.data() + result.size()};
}

TEST(ValveModel, InflatesExponentiallyWithoutARateLimit) {
  const auto pressure = at_constant(lag(0.2, 0.4), 10.0, 60.0, 20);
  for (int k = 0; k <= 20; ++k) {
    EXPECT_NEAR(pressure[std::size_t(k)], 60.0 - 50.0 * std::exp(-k * 0.05 / 0.2), kExactKpa);
  }
}

TEST(ValveModel, VentsWithItsOwnTimeConstant) {
  const auto pressure = at_constant(lag(0.2, 0.4), -60.0, -10.0, 20);
  for (int k = 0; k <= 20; ++k) {
    EXPECT_NEAR(pressure[std::size_t(k)], -10.0 - 50.0 * std::exp(-k * 0.05 / 0.4), kExactKpa);
  }
}

TEST(ValveModel, FollowsTheRateLimitThenTheExponential) {
  // 40 kPa/s until 0.2 s · 40 kPa/s = 8 kPa are left, at 1.05 s.
  const SegmentValves valves{{0.2, 40.0}, {0.1, kNoLimit}, 0.0, 0.0};
  const auto pressure = at_constant(valves, 0.0, 50.0, 40);
  EXPECT_NEAR(pressure[10], 20.0, kExactKpa);
  EXPECT_NEAR(pressure[21], 42.0, kExactKpa);
  EXPECT_NEAR(pressure[40], 50.0 - 8.0 * std::exp(-(2.0 - 1.05) / 0.2), kExactKpa);
}

TEST(ValveModel, RateLimitAloneArrivesExactly) {
  const SegmentValves valves{{0.0, 100.0}, {0.0, 50.0}, 0.0, 0.0};
  EXPECT_NEAR(at_constant(valves, 0.0, 12.0, 2)[2], 10.0, kExactKpa);
  EXPECT_NEAR(at_constant(valves, 0.0, 12.0, 3)[3], 12.0, kExactKpa);
  EXPECT_NEAR(at_constant(valves, 12.0, 0.0, 2)[2], 7.0, kExactKpa);
}

TEST(ValveModel, EmptiesOneSideBeforeTheOtherInflates) {
  // From 40 toward −20: venting pulls toward −20 and is at zero after 0.4 ln(60/20) s.
  const auto pressure = at_constant(lag(0.2, 0.4), 40.0, -20.0, 40);
  const double at_zero_s = 0.4 * std::log(3.0);
  for (int k = 0; k <= 40; ++k) {
    const double t = k * 0.05;
    const double expected = t < at_zero_s ? -20.0 + 60.0 * std::exp(-t / 0.4)
                                          : -20.0 + 20.0 * std::exp(-(t - at_zero_s) / 0.2);
    EXPECT_NEAR(pressure[std::size_t(k)], expected, kExactKpa) << k;
  }
}

TEST(ValveModel, WithoutSidesZeroIsAPlaceLikeAnyOther) {
  const auto rising = at_constant(lag(0.2, 0.4), -1.0, 1.0, 20, false);
  const auto falling = at_constant(lag(0.2, 0.4), 1.0, -1.0, 20, false);
  for (int k = 0; k <= 20; ++k) {
    EXPECT_NEAR(rising[std::size_t(k)], 1.0 - 2.0 * std::exp(-k * 0.05 / 0.2), kExactKpa);
    EXPECT_NEAR(falling[std::size_t(k)], -1.0 + 2.0 * std::exp(-k * 0.05 / 0.4), kExactKpa);
  }
}

TEST(ValveModel, StopsAtTheEdgeOfTheDeadBand) {
  SegmentValves valves = lag(0.1, 0.1);
  valves.dead_band_kpa = 1.5;
  EXPECT_NEAR(at_constant(valves, 0.0, 50.0, 100).back(), 48.5, kExactKpa);
  EXPECT_NEAR(at_constant(valves, 90.0, 50.0, 100).back(), 51.5, kExactKpa);
  EXPECT_NEAR(at_constant(valves, 90.0, -1.0, 200).back(), 0.5, kExactKpa);
  EXPECT_EQ(at_constant(valves, 49.0, 50.0, 100).back(), 49.0);
}

TEST(ValveModel, SwitchesWithinTheFrameAfterADeadTimeOfNoWholeFrames) {
  // 0.13 s at 20 Hz: j = 2, f = 0.6. A set point of frame 1 acts from 0.13 s on.
  SegmentValves valves{{0.0, 100.0}, {0.0, 100.0}, 0.13, 0.0};
  const ValveModel model(one_segment(), same(1, valves));
  EXPECT_EQ(model.setpoint_count(), 3);
  Eigen::MatrixXd setpoints = Eigen::MatrixXd::Constant(1, 8, 50.0);
  setpoints(0, 0) = 0.0;
  const Eigen::MatrixXd pressure = model.run(setpoints, Eigen::VectorXd::Zero(1));
  for (int k = 0; k < 8; ++k) {
    EXPECT_NEAR(pressure(0, k), 100.0 * std::max(0.0, k * 0.05 - 0.13), kExactKpa) << k;
  }
}

TEST(ValveModel, HoldsAsManySetpointsAsMayBeUnderWay) {
  const auto count = [](double dead_time_s) {
    SegmentValves valves = lag(0.1, 0.1);
    valves.dead_time_s = dead_time_s;
    return ValveModel(one_segment(), same(1, valves)).setpoint_count();
  };
  EXPECT_EQ(count(0.0), 1);
  EXPECT_EQ(count(0.03), 1);
  EXPECT_EQ(count(0.05), 1);
  EXPECT_EQ(count(0.051), 2);
  EXPECT_EQ(count(0.15), 3);  // three frames, whatever the rounding
  EXPECT_EQ(ValveModel(one_segment()).setpoint_count(), 1);
}

TEST(ValveModel, AStateHoldsPressuresThenSetpointsNewestFirst) {
  SegmentValves valves = lag(0.1, 0.1);
  valves.dead_time_s = 0.1;
  const ValveModel model(arm_of(2), same(2, valves));
  ASSERT_EQ(model.state_size(), 6);
  Eigen::VectorXf state = model.settled_state(Eigen::Vector2f(5.0F, -5.0F));
  model.step(Eigen::Vector2f(10.0F, 20.0F), state);
  model.step(Eigen::Vector2f(30.0F, 40.0F), state);
  EXPECT_EQ(state.tail(4), Eigen::Vector4f(30.0F, 40.0F, 10.0F, 20.0F));
  EXPECT_EQ(state.head(2), Eigen::Vector2f(5.0F, -5.0F));  // nothing has arrived yet
}

TEST(ValveModel, NeverOvershootsAndNeverTurnsBackAtAConstantSetpoint) {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 300; ++trial) {
    SegmentValves valves = random_valves(random);
    valves.dead_time_s = 0.0;
    const double start = random.uniform(-90.0, 90.0);
    const double setpoint = random.uniform() < 0.2 ? 0.0 : random.uniform(-90.0, 90.0);
    const auto pressure = at_constant(valves, start, setpoint, 30);
    const double sign = setpoint > start ? 1.0 : -1.0;
    for (std::size_t k = 1; k < pressure.size(); ++k) {
      EXPECT_GE(sign * (pressure[k] - pressure[k - 1]), -kExactKpa) << trial;
      EXPECT_LE(sign * (pressure[k] - setpoint), kExactKpa) << trial;
    }
  }
}

TEST(ValveModel, ASettledStateStaysToTheBit) {
  RandomStream random(2, 0);
  for (int trial = 0; trial < 100; ++trial) {
    const ValveModel model(arm_of(1), same(1, random_valves(random)));
    const Pressures kpa = Pressures::Constant(1, float(random.uniform(-90.0, 90.0)));
    Eigen::VectorXf state = model.settled_state(kpa);
    for (int k = 0; k < 10; ++k) {
      model.step(kpa, state);
    }
    EXPECT_EQ(state, model.settled_state(kpa));
  }
}

TEST(ValveModel, HalvesOfAFrameMakeTheWholeFrame) {
  RandomStream random(3, 0);
  constexpr int kFrames = 60;
  for (int trial = 0; trial < 200; ++trial) {
    const SegmentValves valves = random_valves(random);
    const ValveModel whole(one_segment(20.0), same(1, valves));
    const ValveModel half(one_segment(40.0), same(1, valves));
    const Eigen::MatrixXd setpoints = random_setpoints(1, kFrames, random);
    Eigen::MatrixXd doubled(1, 2 * kFrames - 1);
    doubled(0, 0) = setpoints(0, 0);
    for (int k = 1; k < kFrames; ++k) {
      doubled.middleCols(2 * k - 1, 2).setConstant(setpoints(0, k));
    }
    const Eigen::MatrixXd a = whole.run(setpoints, setpoints.col(0));
    const Eigen::MatrixXd b = half.run(doubled, setpoints.col(0));
    for (int k = 0; k < kFrames; ++k) {
      ASSERT_NEAR(a(0, k), b(0, 2 * k), 1e3 * kExactKpa) << "trial " << trial << ", frame " << k;
    }
  }
}

TEST(ValveModel, FloatFollowsDoubleOverLongRandomWalks) {
  RandomStream random(5, 0);
  constexpr int kFrames = 2000;
  for (int trial = 0; trial < 20; ++trial) {
    ValveParameters parameters;
    for (int i = 0; i < 3; ++i) {
      SegmentValves valves = random_valves(random);
      // Where one side empties slowly and the other jumps, a frame stretches any difference by the
      // ratio of their speeds: here by up to 12.
      for (ValveDirection* direction : {&valves.inflating, &valves.venting}) {
        direction->time_constant_s = std::max(direction->time_constant_s, 0.05);
        direction->rate_limit_kpa_per_s = std::clamp(direction->rate_limit_kpa_per_s, 30.0, 300.0);
      }
      parameters.segments.push_back(valves);
    }
    const ValveModel model(arm_of(3), parameters);
    const Eigen::MatrixXd setpoints =
        random_setpoints(3, kFrames, random).cast<float>().cast<double>();
    const Eigen::MatrixXd exact = model.run(setpoints, setpoints.col(0));
    Eigen::VectorXf state = model.settled_state(setpoints.col(0).cast<float>());
    for (int k = 1; k < kFrames; ++k) {
      model.step(setpoints.col(k).cast<float>(), state);
      const double worst = (state.head(3).cast<double>() - exact.col(k)).cwiseAbs().maxCoeff();
      ASSERT_LT(worst, kFloatWalkKpa) << "trial " << trial << ", frame " << k;
    }
  }
}

TEST(ValveModel, BothSidesAreAlike) {
  RandomStream random(7, 0);
  const ValveModel model(arm_of(1), same(1, random_valves(random)));
  const Eigen::MatrixXd setpoints = random_setpoints(1, 500, random);
  EXPECT_EQ(model.run(-setpoints, -setpoints.col(0)), -model.run(setpoints, setpoints.col(0)));
}

TEST(ValveModel, IdealValvesFollowTheSetpoints) {
  const ValveModel model(arm_of(2));
  EXPECT_TRUE(model.is_ideal());
  EXPECT_EQ(model.state_size(), 4);
  Eigen::VectorXf state = model.settled_state(Eigen::Vector2f(1.0F, 2.0F));
  model.step(Eigen::Vector2f(-30.0F, 40.0F), state);
  EXPECT_EQ(state, Eigen::Vector4f(-30.0F, 40.0F, -30.0F, 40.0F));
  RandomStream random(8, 0);
  const Eigen::MatrixXd setpoints = random_setpoints(2, 50, random);
  EXPECT_EQ(model.run(setpoints, setpoints.col(0)), setpoints);
}

TEST(ValveModel, ValvesWithoutLagAreIdeal) {
  const ValveModel model(arm_of(1), same(1, lag(0.0, 0.0)));
  RandomStream random(9, 0);
  const Eigen::MatrixXd setpoints = random_setpoints(1, 200, random);
  const Eigen::MatrixXd pressure = model.run(setpoints, setpoints.col(0));
  EXPECT_LT((pressure - setpoints).cwiseAbs().maxCoeff(), kExactKpa);
}

TEST(ValveModel, StepsWithoutAllocating) {
  if (!kCountsAllocations) {
    GTEST_SKIP() << "the heap belongs to the sanitizer";
  }
  SegmentValves valves{{0.1, 100.0}, {0.2, 100.0}, 0.13, 0.2};
  const ValveModel model(arm_of(3), same(3, valves));
  Eigen::VectorXf state = model.settled_state(Eigen::Vector3f::Zero());
  const Pressures setpoint = Pressures::Constant(3, 40.0F);
  const long before = allocations;
  model.step(setpoint, state);
  EXPECT_EQ(allocations, before);
}

TEST(ValveModel, CountsTheFramesUntilPressuresStayNearTheirSetpoints) {
  // 100 kPa/s and a dead time of two frames: 20 kPa take 2 + 4 frames.
  SegmentValves valves{{0.0, 100.0}, {0.0, 100.0}, 0.1, 0.0};
  const ValveModel model(one_segment(), same(1, valves));
  Eigen::VectorXf state = model.settled_state(Pressures::Zero(1));
  model.step(Pressures::Constant(1, 20.0F), state);  // one frame of them is over then
  const Pressures tolerance = Pressures::Constant(1, float(kFloatKpa));
  EXPECT_EQ(model.frames_to_settle(state, tolerance, 100), 5);
  EXPECT_EQ(model.frames_to_settle(state, tolerance, 3), 3);
  EXPECT_EQ(model.frames_to_settle(model.settled_state(Pressures::Ones(1)), tolerance, 100), 0);
}

TEST(ValveModel, SeesThatAnOlderSetpointIsStillToCome) {
  SegmentValves valves{{0.0, 200.0}, {0.0, 200.0}, 0.1, 0.0};
  const ValveModel model(one_segment(), same(1, valves));
  Eigen::VectorXf state = model.settled_state(Pressures::Zero(1));
  model.step(Pressures::Constant(1, 20.0F), state);
  model.step(Pressures::Zero(1), state);
  // At its set point now, but a frame of 10 kPa and its way back are still to come.
  EXPECT_EQ(state[0], 0.0F);
  EXPECT_EQ(model.frames_to_settle(state, Pressures::Constant(1, float(kFloatKpa)), 100), 2);
}

TEST(ValveModel, NamesBothSizesWhenAStateDoesNotFit) {
  const ValveModel model(arm_of(2));
  Eigen::VectorXf state = Eigen::VectorXf::Zero(5);
  EXPECT_THAT([&] { model.step(Eigen::Vector2f::Zero(), state); },
              ThrowsMessage<InputError>(HasSubstr("a state of size 5; expected 4")));
}

}  // namespace
}  // namespace limber
