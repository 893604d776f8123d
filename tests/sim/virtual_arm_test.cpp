#include "limber/sim/virtual_arm.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

Pressures pressures(std::initializer_list<float> values) {
  Pressures result(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), result.data());
  return result;
}

Pressures random_pressures(RandomStream& random, int segments, double limit_kpa = 100.0) {
  Pressures result(segments);
  for (float& value : result) {
    value = static_cast<float>(random.uniform(-limit_kpa, limit_kpa));
  }
  return result;
}

void expect_equal(const ArmState& a, const ArmState& b) {
  EXPECT_EQ(a.time_s, b.time_s);
  EXPECT_EQ(a.pressure_kpa, b.pressure_kpa);
  ASSERT_EQ(a.backbone.has_value(), b.backbone.has_value());
  if (a.backbone) {
    EXPECT_EQ(*a.backbone, *b.backbone);
  }
}

VirtualArmOptions noisy(double latency_s = 0.0) {
  VirtualArmOptions options;
  options.noise_m = 1e-3;
  options.noise_rad = 1e-2;
  options.noise_kpa = 0.1;
  options.drop_rate = 0.2;
  options.latency_s = latency_s;
  options.seed = 7;
  return options;
}

TEST(VirtualArm, StartsStraightVentedAndAtTimeZero) {
  const ArmDescription arm = sample_arm(3);
  const VirtualArm virtual_arm(arm);
  const ArmState& state = virtual_arm.state();
  EXPECT_EQ(state.time_s, 0.0);
  EXPECT_TRUE(state.pressure_kpa.isZero());
  ASSERT_TRUE(state.backbone);
  ASSERT_EQ(state.backbone->rows(), arm.point_count());
  EXPECT_TRUE(state.backbone->rightCols(2).isZero());
  EXPECT_NEAR(tip_pose(*state.backbone).x_m, arm.length_m(), 1e-6);
}

TEST(VirtualArm, AdvancesOneFramePeriodACommand) {
  ArmDescription arm = sample_arm(2);
  arm.frame_rate_hz = 30.0;  // the period is no multiple of the time step
  VirtualArm virtual_arm(arm);
  EXPECT_LE(virtual_arm.time_step_s(), virtual_arm_parameters(arm).time_step_s);
  for (int frame = 1; frame <= 30; ++frame) {
    virtual_arm.command(pressures({0.0F, 0.0F}));
  }
  EXPECT_NEAR(virtual_arm.state().time_s, 1.0, 1e-12);
}

TEST(VirtualArm, BendsTowardTheInflatedSideAndUnwrapsItsAngles) {
  const ArmDescription arm = sample_arm(3);
  VirtualArm virtual_arm(arm);
  virtual_arm.settle(pressures({100.0F, 100.0F, 100.0F}), 6.0);
  const Pose right = tip_pose(virtual_arm.true_backbone());
  EXPECT_LT(right.theta_rad, -M_PI);  // the arm curls up further than half a turn
  EXPECT_LT(virtual_arm.right_strain(2), -0.1);
  virtual_arm.settle(pressures({-100.0F, -100.0F, -100.0F}), 6.0);
  EXPECT_GT(tip_pose(virtual_arm.true_backbone()).theta_rad, M_PI);
  EXPECT_LT(virtual_arm.left_strain(2), -0.1);
}

TEST(VirtualArm, RepeatsTheSameMotionToTheBitFromASavedState) {
  ArmDescription arm = sample_arm(3);
  for (const double latency_s : {0.0, 0.07}) {
    change_virtual_arm(
        arm, [&](VirtualArmParameters& p) { p.valve_dead_time_s = latency_s > 0.0 ? 0.13 : 0.0; });
    VirtualArm first(arm, noisy(latency_s));
    VirtualArm second(arm, noisy(latency_s));
    RandomStream random(3, 0);
    for (int motion = 0; motion < 3; ++motion) {
      first.settle(random_pressures(random, 3), 0.6);
    }
    const VirtualArmState saved = first.save();
    const Pressures next = random_pressures(random, 3);
    std::vector<ArmState> expected;
    for (int frame = 0; frame < 20; ++frame) {
      expected.push_back(first.command(next));
    }
    const BackboneD truth = first.true_backbone();
    for (VirtualArm* again : {&first, &second}) {
      again->restore(saved);
      for (const ArmState& state : expected) {
        expect_equal(again->command(next), state);
      }
      EXPECT_EQ(again->true_backbone(), truth);
    }
  }
}

TEST(VirtualArm, BecomesTheLaterArmInTheStateThatItIsIn) {
  const ArmDescription arm = sample_arm(2);
  ArmDescription loaded = arm;
  change_virtual_arm(loaded, [](auto& p) { p.tip_load_kg += 0.1; });
  VirtualArmOptions options;
  options.later = loaded;
  options.later_from_s = 9.5 * arm.frame_period_s();
  VirtualArm changing(arm, options);
  VirtualArm unchanged(arm);
  RandomStream random(3, 0);
  for (int k = 0; k < 9; ++k) {
    const Pressures kpa = random_pressures(random, 2);
    expect_equal(changing.command(kpa), unchanged.command(kpa));
  }
  // In the middle of the tenth frame; what comes then is that of a loaded arm in the same state.
  changing.restore(unchanged.save());
  options.later_from_s = 9.0 * arm.frame_period_s();
  VirtualArm after(arm, options);
  after.restore(unchanged.save());
  VirtualArm heavy(loaded);
  heavy.restore(unchanged.save());
  double apart_m = 0.0;
  for (int k = 0; k < 20; ++k) {
    const Pressures kpa = random_pressures(random, 2);
    expect_equal(after.command(kpa), heavy.command(kpa));
    changing.command(kpa);
    unchanged.command(kpa);
    apart_m = std::max(
        apart_m, (changing.true_backbone() - unchanged.true_backbone()).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(apart_m, 1e-3);
}

TEST(VirtualArm, SetpointsArriveAfterTheDeadTime) {
  ArmDescription arm = sample_arm(2);
  VirtualArm prompt(arm);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) {
    p.valve_dead_time_s = 0.15;  // three frames
  });
  VirtualArm late(arm);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.valve_dead_time_s = 0.13; });
  VirtualArm within_a_frame(arm);
  RandomStream random(5, 0);
  std::vector<Eigen::VectorXd> expected;
  for (int frame = 0; frame < 30; ++frame) {
    const Pressures setpoint = random_pressures(random, 2);
    prompt.command(setpoint);
    late.command(setpoint);
    within_a_frame.command(setpoint);
    expected.push_back(prompt.true_pressure_kpa());
    if (frame >= 3) {
      EXPECT_EQ(late.true_pressure_kpa(), expected[std::size_t(frame) - 3]);
    } else {
      EXPECT_TRUE(late.true_pressure_kpa().isZero(0.0));
    }
    EXPECT_EQ(within_a_frame.true_pressure_kpa().isZero(0.0), frame < 2);
  }
}

TEST(VirtualArm, ASafetyVentDoesNotWaitForTheDeadTime) {
  ArmDescription arm = sample_arm(1);
  change_virtual_arm(arm, [&](VirtualArmParameters& p) { p.valve_dead_time_s = 0.5; });
  VirtualArm late(arm);
  late.settle(pressures({50.0F}), 3.0);
  late.command(pressures({90.0F}));
  late.vent();
  const double before = late.true_pressure_kpa()[0];
  late.restore(late.save());
  EXPECT_TRUE(late.save().pending_setpoints.empty());
  late.command(pressures({0.0F}));
  EXPECT_LT(late.true_pressure_kpa()[0], before);
}

// Whoever serves it tells it to rest, frame by frame, and its dead band would leave air in it.
TEST(VirtualArm, AVentedArmThatIsToldToRestStaysVented) {
  ArmDescription description = sample_arm(1);
  change_virtual_arm(description, [&](VirtualArmParameters& p) {
    p.valve_dead_time_s = 0.0;
    p.pressure_dead_band_kpa = 5.0;
  });
  VirtualArm arm(description);
  arm.settle(pressures({50.0F}), 3.0);
  for (int frame = 0; frame < 100; ++frame) {
    arm.vent();
    arm.command(pressures({0.0F}));
  }
  EXPECT_LT(std::abs(arm.true_pressure_kpa()[0]), 0.5);
  arm.command(pressures({1.0F}));
  EXPECT_FALSE(arm.save().vented);
}

TEST(VirtualArm, RefusesAnotherArmsState) {
  VirtualArm three(sample_arm(3));
  const VirtualArm two(sample_arm(2));
  EXPECT_THAT([&] { three.restore(two.save()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("position"), HasSubstr("'sample3'"))));
  VirtualArmState short_of_one = three.save();
  short_of_one.table_anchor_rad.pop_back();
  EXPECT_THAT([&] { three.restore(short_of_one); },
              ThrowsMessage<InputError>(HasSubstr("table_anchor_rad")));
}

TEST(VirtualArm, RefusesSetPointsBeyondLimitsBeforeAnythingMoves) {
  VirtualArm arm(sample_arm(2));
  const BackboneD before = arm.true_backbone();
  EXPECT_THAT(
      [&] {
        arm.command(pressures({0.0F, 100.1F}));
      },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("segment 1"), HasSubstr("100.1"), HasSubstr("-100 to 100 kPa"))));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        arm.command(pressures({nan, 0.0F}));
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("segment 0"), HasSubstr("nan"))));
  EXPECT_THAT([&] { arm.command(pressures({0.0F})); },
              ThrowsMessage<InputError>(HasSubstr("1 set points; arm 'sample2' has 2 segments")));
  EXPECT_EQ(arm.state().time_s, 0.0);
  EXPECT_EQ(arm.true_backbone(), before);
}

TEST(VirtualArm, ClampsExcessOfRounding) {
  VirtualArm arm(sample_arm(1));
  arm.settle(pressures({100.0005F}), 3.0);
  EXPECT_LE(arm.true_pressure_kpa()[0], 100.0);
}

TEST(VirtualArm, RefusesOptionsOutOfRange) {
  VirtualArmOptions options;
  options.drop_rate = 1.5;
  EXPECT_THAT([&] { VirtualArm arm(sample_arm(1), options); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("drop_rate = 1.5"), HasSubstr("0 to 1"))));
  options = {};
  options.latency_s = -0.1;
  EXPECT_THAT([&] { VirtualArm arm(sample_arm(1), options); },
              ThrowsMessage<InputError>(HasSubstr("latency_s = -0.1")));
}

TEST(VirtualArm, VentsToZeroWhateverWasCommanded) {
  VirtualArm arm(sample_arm(2));
  arm.settle(pressures({100.0F, -60.0F}), 2.0);
  arm.vent();
  arm.vent();
  EXPECT_TRUE(arm.save().vented);
  EXPECT_EQ(arm.save().setpoint_kpa, (std::vector<double>{0.0, 0.0}));
}

// A signed pressure is one side's; the other must not pull: its braid alone may resist.
TEST(VirtualArm, NeverPressurisesBothSides) {
  ArmDescription description = sample_arm(1);
  VirtualArm arm(description);
  RandomStream random(4, 0);
  double last = 0.0;
  for (int motion = 0; motion < 10; ++motion) {
    const Pressures setpoint = random_pressures(random, 1);
    for (int frame = 0; frame < 40; ++frame) {
      arm.command(setpoint);
      const double now = arm.true_pressure_kpa()[0];
      // Within a frame the pressure moves by the rate limit at most, so it passes through zero.
      EXPECT_LE(std::abs(now - last), 100.0 * description.frame_period_s() + 1e-9);
      last = now;
    }
  }
}

TEST(VirtualArm, ShowsItsObserverEverySimulatorStep) {
  const ArmDescription description = sample_arm(2);
  VirtualArm arm(description);
  std::vector<double> times;
  BackboneD last;
  arm.set_observer([&](double time_s, const BackboneD& backbone) {
    times.push_back(time_s);
    last = backbone;
  });
  arm.command(pressures({50.0F, -50.0F}));
  ASSERT_EQ(times.size(), 50U);
  EXPECT_NEAR(times.front(), 1e-3, 1e-15);
  EXPECT_NEAR(times.back(), 0.05, 1e-15);
  EXPECT_EQ(last, arm.true_backbone());
  arm.set_observer({});
  arm.command(pressures({50.0F, -50.0F}));
  EXPECT_EQ(times.size(), 50U);
}

TEST(VirtualArm, MeasuresWithTheNoiseAskedFor) {
  VirtualArmOptions options;
  options.noise_m = 2e-3;
  options.noise_rad = 0.01;
  options.noise_kpa = 0.5;
  VirtualArm arm(sample_arm(3), options);
  double squares_m = 0.0;
  double squares_rad = 0.0;
  double squares_kpa = 0.0;
  constexpr int kFrames = 100;
  for (int frame = 0; frame < kFrames; ++frame) {
    const ArmState& state = arm.command(pressures({0.0F, 0.0F, 0.0F}));
    const BackboneD error = state.backbone->cast<double>() - arm.true_backbone();
    squares_m += error.leftCols(2).squaredNorm() / 32.0;
    squares_rad += error.col(2).squaredNorm() / 16.0;
    squares_kpa += state.pressure_kpa.squaredNorm() / 3.0F;
  }
  // Four standard errors of a deviation from 300, 1600 and 3200 draws.
  EXPECT_NEAR(std::sqrt(squares_m / kFrames), 2e-3, 2e-3 * 0.05);
  EXPECT_NEAR(std::sqrt(squares_rad / kFrames), 0.01, 0.01 * 0.07);
  EXPECT_NEAR(std::sqrt(squares_kpa / kFrames), 0.5, 0.5 * 0.17);
}

TEST(VirtualArm, MeasurementFaultsLeaveTheMotionAsItIs) {
  VirtualArm clean(sample_arm(2));
  VirtualArm faulty(sample_arm(2), noisy(0.12));
  clean.settle(pressures({80.0F, -40.0F}), 1.0);
  faulty.settle(pressures({80.0F, -40.0F}), 1.0);
  EXPECT_EQ(clean.true_backbone(), faulty.true_backbone());
}

TEST(VirtualArm, DropsTheShareOfFramesAskedForAndTheSameOnesForASeed) {
  const auto drops = [](std::uint64_t seed) {
    VirtualArmOptions options = noisy();
    options.seed = seed;
    VirtualArm arm(sample_arm(1), options);
    std::vector<bool> result;
    for (int frame = 0; frame < 400; ++frame) {
      result.push_back(!arm.command(pressures({0.0F})).backbone);
    }
    return result;
  };
  const std::vector<bool> first = drops(7);
  EXPECT_EQ(first, drops(7));
  EXPECT_NE(first, drops(8));
  const auto dropped = std::count(first.begin(), first.end(), true);
  EXPECT_NEAR(static_cast<double>(dropped) / 400.0, 0.2, 0.08);  // four standard errors
}

// 70 ms at 20 Hz: a frame and two fifths, to the simulator step.
TEST(VirtualArm, DelaysWhatItMeasuresByTheLatency) {
  const ArmDescription description = sample_arm(2);
  VirtualArmOptions options;
  options.latency_s = 0.07;
  VirtualArm arm(description, options);
  std::vector<BackboneD> truth = {arm.true_backbone()};  // one a simulator step
  arm.set_observer([&](double, const BackboneD& backbone) { truth.push_back(backbone); });
  for (int frame = 1; frame <= 20; ++frame) {
    const ArmState& state = arm.command(pressures({90.0F, -90.0F}));
    EXPECT_NEAR(state.time_s, 0.05 * frame, 1e-12);
    const std::size_t then = frame == 1 ? 0 : static_cast<std::size_t>(50 * frame - 70);
    EXPECT_EQ(*state.backbone, truth[then].cast<float>()) << "frame " << frame;
  }
}

TEST(VirtualArm, SaysWhenAndAtWhatPressureItBlewUp) {
  ArmDescription description = sample_arm(2);
  change_virtual_arm(description, [&](VirtualArmParameters& p) {
    p.time_step_s = 0.01;
    p.hysteresis_stiffness_n_per_m = 1e9;
    p.hysteresis_fraction = 1e3;
  });
  VirtualArm arm(description);
  const VirtualArmState rest = arm.save();
  const auto run = [&] { arm.settle(pressures({100.0F, -100.0F}), 20.0); };
  EXPECT_THAT(run, ThrowsMessage<SystemFault>(AllOf(HasSubstr("'sample2' blew up at "),
                                                    HasSubstr("kPa, set points [100, -100] kPa"),
                                                    HasSubstr("time step 0.01 s"))));
  EXPECT_THAT(run, ThrowsMessage<SystemFault>(HasSubstr("blew up at ")));  // and stays down
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
  arm.restore(rest);
  EXPECT_EQ(arm.state().time_s, 0.0);
}

}  // namespace
}  // namespace limber
