#include "limber/run/safety_gate.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/straight_motion.hpp"
#include "support/fake_arm.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr float kLimitKpa = 100.0F;  // of small_arm, 10 kPa a frame

class SafetyGateTest : public ::testing::Test {
 protected:
  SafetyGate gate(bool check_rate = true) const {
    return SafetyGate(arm_, {kLimitKpa, kLimitKpa}, check_rate, settings_);
  }

  static Pressures pressures(float first, float second) {
    Pressures result(2);
    result << first, second;
    return result;
  }

  ArmState measured(const Pressures& pressure_kpa) const {
    ArmState state;
    state.pressure_kpa = pressure_kpa;
    return state;
  }

  ArmState seen(float tip_y_m) const {
    ArmState state = measured(pressures(0, 0));
    state.backbone = Backbone::Zero(arm_.point_count(), 3);
    (*state.backbone)(arm_.point_count() - 1, 1) = tip_y_m;
    return state;
  }

  /// Commands `setpoint` for `frames` frames while segment 0 reads `reading(frame)`.
  template <class Reading>
  std::string run(SafetyGate& gate, float setpoint, int frames, const Reading& reading) const {
    for (int k = 0; k < frames; ++k) {
      std::string wrong = gate.check_command(pressures(setpoint, 0));
      wrong = wrong.empty() ? gate.check_state(measured(pressures(reading(k), 0))) : wrong;
      if (!wrong.empty()) {
        return fmt::format("frame {}: {}", k, wrong);
      }
    }
    return "";
  }

  ArmDescription arm_ = small_arm();
  SafetySettings settings_;
};

TEST_F(SafetyGateTest, PassesLimitsAndRefusesWhatIsBeyond) {
  SafetyGate gate = this->gate(false);
  EXPECT_THAT(gate.check_command(pressures(100.0F, -100.0F)), IsEmpty());
  EXPECT_THAT(gate.check_command(pressures(0.0F, -100.1F)), HasSubstr("segment 1 is -100.1 kPa"));
  EXPECT_THAT(gate.check_command(pressures(std::nanf(""), 0.0F)), HasSubstr("segment 0"));
  EXPECT_THAT(gate.check_command(pressures(INFINITY, 0.0F)), HasSubstr("segment 0"));
}

TEST_F(SafetyGateTest, RefusesAStepBeyondTheRateOnlyWhereRatesCount) {
  SafetyGate strict = gate();
  EXPECT_THAT(strict.check_command(pressures(10.0F, -10.0F)), IsEmpty());
  EXPECT_THAT(strict.check_command(pressures(20.0F, -20.5F)),
              HasSubstr("segment 1 goes from -10.00 to -20.50 kPa"));
  // What was refused was not taken for what is in force.
  EXPECT_THAT(strict.check_command(pressures(20.0F, -20.0F)), IsEmpty());
  EXPECT_THAT(gate(false).check_command(pressures(100.0F, -100.0F)), IsEmpty());
}

TEST_F(SafetyGateTest, VentedArmsStartFromZeroAgain) {
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_command(pressures(10.0F, 0.0F)), IsEmpty());
  gate.note_vented(measured(pressures(0, 0)));
  EXPECT_THAT(gate.check_command(pressures(20.0F, 0.0F)), HasSubstr("from 0.00 to 20.00"));
}

TEST_F(SafetyGateTest, PressureMayBeFivePercentOverTheLimitAndNoMore) {
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_shape(measured(pressures(0.0F, -105.0F))), IsEmpty());
  EXPECT_THAT(gate.check_shape(measured(pressures(0.0F, -105.1F))), HasSubstr("segment 1"));
}

TEST_F(SafetyGateTest, ALaggingValveFollowsAndASlackOneDoesNot) {
  SafetyGate lagging = gate(false);
  const auto lag = [](int k) { return 90.0F * (1.0F - std::exp(-0.15F * float(k))); };
  EXPECT_THAT(run(lagging, 90.0F, 60, lag), IsEmpty());
  SafetyGate slack = gate(false);
  const std::string wrong =
      run(slack, 90.0F, 60, [&](int k) { return std::min(lag(k), 60.0F + 0.2F * float(k % 2)); });
  EXPECT_THAT(wrong, HasSubstr("Check supply pressure"));
}

TEST_F(SafetyGateTest, AFaultOfFollowingTakesHalfASecondAndMore) {
  SafetyGate gate = this->gate(false);
  EXPECT_THAT(run(gate, 50.0F, 40, [](int k) { return std::min(10.0F * float(k), 50.0F); }),
              IsEmpty());
  EXPECT_THAT(run(gate, 50.0F, 10, [](int k) { return 30.0F + 0.1F * float(k); }), IsEmpty());
  EXPECT_THAT(run(gate, 50.0F, 5, [](int) { return 30.0F; }), HasSubstr("segment 0 is at 30.0"));
}

// The arm file's rate is what plans keep to; a step may be followed much faster.
TEST_F(SafetyGateTest, ValvesFasterThanTheArmsRateAreNoFault) {
  SafetyGate gate = this->gate(false);
  float now = 0.0F;
  for (const int frames : {7, 12, 19, 25}) {
    for (const float setpoint : {90.0F, -90.0F, -60.0F, 90.0F, 0.0F}) {
      const auto fast = [&](int) {
        now += std::clamp(setpoint - now, -40.0F, 40.0F);
        return now;
      };
      EXPECT_THAT(run(gate, setpoint, frames, fast), IsEmpty()) << frames << " to " << setpoint;
    }
  }
  const auto still = [&](int) { return 0.0F; };
  EXPECT_THAT(run(gate, 50.0F, 60, still), HasSubstr("stands still"));
}

TEST_F(SafetyGateTest, AStuckChannelIsFoundWithinItsFirstSeconds) {
  SafetyGate gate = this->gate(false);
  const std::string wrong = run(gate, 8.0F, 60, [](int) { return 0.0F; });
  EXPECT_THAT(wrong, HasSubstr("stands still at 0.00 kPa"));
}

// docs/driver.md: a state has the newest sample, and the set point in force when that was taken.
TEST_F(SafetyGateTest, AtOneFramePerSecondAStateMayBeOfTheFrameBefore) {
  for (const double rate_hz : {1.0, 2.0, 5.0}) {
    arm_.frame_rate_hz = rate_hz;
    SafetyGate gate = this->gate();
    float before = 0.0F;
    for (const float setpoint : {0.0F, 40.0F, 80.0F, 40.0F, 0.0F, -40.0F, -40.0F, -40.0F, 0.0F}) {
      ASSERT_THAT(gate.check_command(pressures(setpoint, 0)), IsEmpty());
      ArmState state = measured(pressures(std::exchange(before, setpoint), 0));
      state.setpoint_kpa = state.pressure_kpa;
      ASSERT_THAT(gate.check_state(state), IsEmpty()) << rate_hz << " Hz, to " << setpoint;
    }
    SafetyGate still = this->gate();
    EXPECT_THAT(run(still, 40.0F, 10, [](int) { return 0.0F; }), HasSubstr("segment 0")) << rate_hz;
  }
}

TEST_F(SafetyGateTest, AHeldSetpointMayReadTheSameForever) {
  SafetyGate gate = this->gate(false);
  EXPECT_THAT(run(gate, 8.0F, 200, [](int k) { return k < 5 ? 2.0F * float(k) : 8.0F; }),
              IsEmpty());
}

TEST_F(SafetyGateTest, AnArmDoesNotJump) {
  settings_.jump_m = 0.05;
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_shape(seen(0.0F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.049F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.100F)),
              HasSubstr("plate 4 jumped by 5.10 cm within 1 frame"));
}

// Four lengths per second: 1.6 m/s of an arm of 0.4 m, 8 cm in a frame.
TEST_F(SafetyGateTest, WhatIsAJumpFollowsFromTheArmsLengthAndRate) {
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_shape(seen(0.0F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.079F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.161F)), HasSubstr("more than 8.00 cm per frame"));
  arm_.frame_rate_hz = 40.0;
  EXPECT_DOUBLE_EQ(largest_jump_m(settings_, arm_), 0.04);
  arm_ = load_arm(LIMBER_SOURCE_DIR "/arms/two_segment.yaml");
  EXPECT_NEAR(largest_jump_m(settings_, arm_), 0.094, 1e-9);
  settings_.jump_m = 0.3;
  EXPECT_EQ(largest_jump_m(settings_, arm_), 0.3);
}

// A tracker in mm, say.
TEST_F(SafetyGateTest, AJumpOfAShapeInAnotherUnitSaysSo) {
  SafetyGate gate = this->gate();
  ArmState state = measured(pressures(0, 0));
  for (const float y_mm : {0.0F, 700.0F}) {
    state.backbone = Backbone::Zero(arm_.point_count(), 3);
    for (Eigen::Index i = 0; i < arm_.point_count(); ++i) {
      (*state.backbone)(i, 0) = 100.0F * static_cast<float>(i);
      (*state.backbone)(i, 1) = y_mm;
    }
    const std::string wrong = gate.check_shape(state);
    EXPECT_EQ(wrong.empty(), y_mm == 0.0F);
    if (!wrong.empty()) {
      EXPECT_THAT(wrong, HasSubstr("The shape is 400 m long from plate to plate, and the arm 0.4"));
    }
  }
}

TEST_F(SafetyGateTest, AfterAVentAJumpIsOneToo) {
  SafetyGate gate = this->gate();
  gate.note_vented(seen(0.0F));
  EXPECT_THAT(gate.check_shape(seen(0.1F)), HasSubstr("jumped by 10.00 cm within 1 frame"));
  gate.note_vented(seen(0.0F));
  ArmState later = seen(0.1F);
  later.time_s = 0.15;  // three frames in which nobody looked
  EXPECT_THAT(gate.check_shape(later), IsEmpty());
}

TEST_F(SafetyGateTest, UnseenFramesGiveTimeToMove) {
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_shape(seen(0.0F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(measured(pressures(0, 0))), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.099F)), IsEmpty());
}

TEST_F(SafetyGateTest, EveryPlateStaysWithinTheFence) {
  settings_.fence = Fence{-0.1, 0.5, -0.2, 0.2};
  settings_.jump_m = 1.0;
  SafetyGate gate = this->gate();
  EXPECT_THAT(gate.check_shape(seen(0.19F)), IsEmpty());
  EXPECT_THAT(gate.check_shape(seen(0.21F)), HasSubstr("outside of the fence"));
}

// An arm in space has more channels than segments, and its plates have a height.
TEST_F(SafetyGateTest, OfAnArmInSpaceItWatchesEveryChamberAndPlate) {
  const ArmDescription arm = testing_support::space_arm();
  settings_.fence = Fence{-1.0, 1.0, -1.0, 1.0, -0.2, 0.2};
  SafetyGate gate(arm, std::vector<PressureLimits>(6, PressureLimits(0.0, 100.0)), false,
                  settings_);
  ArmState state = measured(Pressures::Zero(6));
  const auto seen_at = [&](float z_m) {
    state.space_backbone = SpaceBackbone::Zero(arm.point_count(), kSpacePoseSize);
    (*state.space_backbone)(arm.point_count() - 1, 2) = z_m;
    return gate.check_shape(state);
  };
  EXPECT_THAT(seen_at(0.0F), IsEmpty());
  EXPECT_THAT(seen_at(0.06F), IsEmpty());
  EXPECT_THAT(seen_at(0.19F), HasSubstr("plate 5 jumped by 13.00 cm"));
  EXPECT_THAT(seen_at(0.21F), HasSubstr("(0.000, 0.000, 0.210) m, outside of the fence"));
  state.space_backbone.reset();
  Pressures last = Pressures::Zero(6);
  last[5] = 50.0F;
  std::string wrong;
  for (int k = 0; k < 60 && wrong.empty(); ++k) {
    wrong = gate.check_command(last);
    wrong = wrong.empty() ? gate.check_state(state) : wrong;
  }
  EXPECT_THAT(wrong, HasSubstr("chamber 2 of segment 1 stands still"));
}

TEST_F(SafetyGateTest, TheFollowingTimeMayBeLongerThanASecond) {
  settings_.following_time_s = 2.0;
  settings_.stuck_change_kpa = 1e9;
  SafetyGate gate = this->gate(false);
  // 1.6 s behind a set point that went to 50 kPa and back: within 2 s it was sent.
  const auto delayed = [](int k) { return k >= 32 && k < 40 ? 50.0F : 0.0F; };
  std::string wrong;
  for (int k = 0; k < 60 && wrong.empty(); ++k) {
    wrong = gate.check_command(pressures(k < 8 ? 50.0F : 0.0F, 0.0F));
    ArmState state = measured(pressures(0.0F, 0.0F));
    state.setpoint_kpa = pressures(delayed(k), 0.0F);
    wrong = wrong.empty() ? gate.check_state(state) : wrong;
  }
  EXPECT_THAT(wrong, IsEmpty());
}

// The watch has to leave a healthy arm alone, whatever it is asked for.
TEST_F(SafetyGateTest, AHealthyVirtualArmPassesJumpsAndStraightMotions) {
  const ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/two_segment.yaml");
  VirtualArm driver(arm);
  SafetyGate gate(arm, {100.0, 100.0}, false, settings_);
  const std::vector<Pressures> targets = {pressures(100, -100), pressures(-100, 100),
                                          pressures(-100, -100), pressures(7, 3), pressures(0, 0)};
  Pressures from = Pressures::Zero(2);
  for (const bool straight : {false, true}) {
    for (const Pressures& target : targets) {
      std::vector<Pressures> frames(40, target);
      if (straight) {
        const int count = motion_frame_count(from, target, arm.pressure_step_limit_kpa());
        frames.resize(static_cast<std::size_t>(count), target);
        for (int k = 1; k <= count; ++k) {
          motion_setpoint(from, target, k, count, frames[static_cast<std::size_t>(k) - 1]);
        }
      }
      for (const Pressures& setpoint_kpa : frames) {
        ASSERT_THAT(gate.check_command(setpoint_kpa), IsEmpty());
        ASSERT_THAT(gate.check_state(driver.command(setpoint_kpa)), IsEmpty());
      }
      from = target;
    }
  }
}

TEST(SafetySettings, AreReadFromTheArmFileAndDefaultWithoutIt) {
  const TemporaryFolder folder;
  const std::string arm = read_file(LIMBER_SOURCE_DIR "/arms/two_segment.yaml");
  const auto write = [&](const std::string& name, const std::string& more) {
    write_file_atomically(folder.path() / name, arm + more);
    return folder.path() / name;
  };
  EXPECT_EQ(load_safety(write("a.yaml", "")).following_error_kpa, 10.0);
  const SafetySettings safety =
      load_safety(write("b.yaml",
                        "safety:\n  following_error_kpa: 4\n"
                        "  fence: {x_min_m: -0.1, x_max_m: 0.6, y_min_m: -0.4, y_max_m: 0.4}\n"));
  EXPECT_EQ(safety.following_error_kpa, 4.0);
  EXPECT_EQ(safety.fence->x_max_m, 0.6);
  EXPECT_EQ(safety.fence->z_max_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(load_arm(folder.path() / "b.yaml").hash(), load_arm(folder.path() / "a.yaml").hash());
  EXPECT_THAT([&] { (void)load_safety(write("c.yaml", "safety: {jump_cm: 5}\n")); },
              ThrowsMessage<InputError>(HasSubstr("safety.jump_cm")));
  EXPECT_THAT(
      [&] {
        (void)load_safety(
            write("d.yaml", "safety: {fence: {x_min_m: 1, x_max_m: 0, y_min_m: 0, y_max_m: 1}}\n"));
      },
      ThrowsMessage<InputError>(HasSubstr("x_min_m < x_max_m")));
}

TEST_F(SafetyGateTest, KeepsTheLimitOfEachSide) {
  SafetyGate gate(arm_, {PressureLimits(-20.0, 100.0), PressureLimits(0.0, 50.0)}, false,
                  settings_);
  EXPECT_THAT(gate.check_command(pressures(-20.0F, 50.0F)), IsEmpty());
  EXPECT_THAT(gate.check_command(pressures(-20.1F, 0)),
              HasSubstr("segment 0 is -20.1 kPa; its limit is -20 kPa"));
  EXPECT_THAT(gate.check_command(pressures(0, -0.1F)),
              HasSubstr("segment 1 is -0.1 kPa; its limit is 0 kPa"));
  // 5 % of the arm's limit of 100 kPa are allowed beyond, on either side.
  EXPECT_THAT(gate.check_shape(measured(pressures(-24.9F, -4.9F))), IsEmpty());
  EXPECT_THAT(gate.check_shape(measured(pressures(-25.1F, 0))),
              HasSubstr("its limit is -20.0 kPa"));
  EXPECT_THAT(gate.check_shape(measured(pressures(0, 55.1F))), HasSubstr("its limit is 50.0 kPa"));
}

TEST(SafetySettings, ScalesAreOverZeroAndAtMostOne) {
  ArmDescription arm = small_arm();
  arm.segments[0].pressure_limit_kpa = PressureLimits(-40.0, 100.0);
  EXPECT_EQ(with_scaled_limits(arm, 0.25).segments[0].pressure_limit_kpa,
            PressureLimits(-10.0, 25.0));
  EXPECT_EQ(with_scaled_limits(arm, 0.25).segments[1].pressure_limit_kpa, 25.0);
  for (const double scale : {0.0, -0.5, 1.01, std::nan("")}) {
    EXPECT_THAT([&] { (void)with_scaled_limits(arm, scale); },
                ThrowsMessage<InputError>(HasSubstr("limit scale")));
  }
}

}  // namespace
}  // namespace limber
