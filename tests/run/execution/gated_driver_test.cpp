#include "limber/run/gated_driver.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/driver/segment_bench.hpp"
#include "limber/run/collection.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/plan_controller.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// A user's driver in this process: it has no checks of its own, and counts.
class TrustingArm final : public ArmDriver {
 public:
  explicit TrustingArm(const ArmDescription& arm) : arm_(arm, 1e-4) {}

  const ArmState& state() const override { return arm_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    largest_kpa = std::max(largest_kpa, setpoint_kpa.cwiseAbs().maxCoeff());
    largest_step_kpa = std::max(largest_step_kpa,
                                (setpoint_kpa - arm_.state().pressure_kpa).cwiseAbs().maxCoeff());
    return arm_.command(setpoint_kpa);
  }
  void vent() noexcept override { ++vents; }

  float largest_kpa = 0.0F;
  float largest_step_kpa = 0.0F;
  int vents = 0;

 private:
  FakeArm arm_;
};

constexpr float kLimitKpa = 100.0F;  // of small_arm …
constexpr float kStepKpa = 10.0F;    // … and what its rate allows in a frame
constexpr float kRoundingKpa = 0.01F;

class GatedDriverTest : public ::testing::Test {
 protected:
  void expect_untouched() const {
    EXPECT_LE(arm_driver_.largest_kpa, kLimitKpa + kRoundingKpa);
    EXPECT_LE(arm_driver_.largest_step_kpa, kStepKpa + kRoundingKpa);
  }

  /// A motion as a caller of the library may ask for it.
  static EpisodeSchedule to(float kpa, Approach approach) {
    EpisodeSchedule schedule;
    schedule.approach = approach;
    schedule.first_kpa = Pressures::Zero(2);
    schedule.motions = {{Pressures::Constant(2, kpa), 0.2, false}};
    return schedule;
  }

  ArmDescription arm_ = small_arm();
  TrustingArm arm_driver_{arm_};
};

TEST_F(GatedDriverTest, PassesWhatIsAllowedAndNothingElse) {
  GatedDriver gated(arm_, arm_driver_, true);
  EXPECT_EQ(gated.command(Pressures::Constant(2, 9.0F)).pressure_kpa,
            arm_driver_.state().pressure_kpa);
  const auto refused = [&](const Pressures& setpoint_kpa, const char* message) {
    EXPECT_THAT([&] { gated.command(setpoint_kpa); },
                ThrowsMessage<SystemFault>(HasSubstr(message)));
  };
  refused(Pressures::Constant(2, 20.0F), "goes from 9.00 to 20.00 kPa in a frame");
  refused(Pressures::Constant(2, -101.0F), "its limit is 100 kPa. It was not sent");
  refused(Pressures::Constant(2, std::numeric_limits<float>::quiet_NaN()), "is nan kPa");
  refused(Pressures::Zero(3), "3 set points; arm 'small' has 2 segments");
  expect_untouched();
}

/// Plans again as it likes: what is sent in a frame is the last thing that it decides.
class WildSource final : public PlanController {
 public:
  explicit WildSource(Pressures sent_kpa) : sent_kpa_(std::move(sent_kpa)) {}
  FrameSetpoint setpoint(const PlanProgress& at, std::size_t next,
                         const ArmEstimate& arm) override {
    return at.frame == 3 ? FrameSetpoint{sent_kpa_, next} : PlanController::setpoint(at, next, arm);
  }

 private:
  Pressures sent_kpa_;
};

// Plans are checked before they are executed, and what replaces their set points in every frame.
TEST_F(GatedDriverTest, AnExecutionKeepsLimitsAndRateWhateverDecides) {
  Environment environment;
  environment.name = "test";
  for (const float kpa : {60.0F, 150.0F}) {
    WildSource source(Pressures::Constant(2, kpa));
    ExecutionSettings settings;
    settings.controller = &source;
    TrustingArm driver(arm_);
    EXPECT_THROW(
        (void)execute(arm_, environment, bending_plan(arm_, environment), driver, settings),
        InputError);
    EXPECT_LE(driver.largest_step_kpa, kStepKpa + kRoundingKpa);
    EXPECT_EQ(driver.vents, 1);
  }
}

TEST_F(GatedDriverTest, ARecordingKeepsTheLimitsAndWhereItSaysSoTheRate) {
  const auto record = [&](TrustingArm& driver, float kpa, Approach approach) {
    (void)record_episode(arm_, driver, to(kpa, approach), {});
  };
  EXPECT_THAT([&] { record(arm_driver_, 150.0F, Approach::straight); },
              ThrowsMessage<SystemFault>(HasSubstr("its limit is 100 kPa")));
  expect_untouched();
  EXPECT_EQ(arm_driver_.vents, 1);
  TrustingArm stepping(arm_);  // its set points jump, and the valves ramp
  EXPECT_NO_THROW(record(stepping, 50.0F, Approach::step));
  EXPECT_EQ(stepping.largest_step_kpa, 50.0F);
  EXPECT_THAT([&] { record(stepping, 150.0F, Approach::step); },
              ThrowsMessage<SystemFault>(HasSubstr("its limit is 100 kPa")));
}

/// Of two segments, and says what it is told to say.
class SayingArm final : public ArmDriver {
 public:
  explicit SayingArm(const ArmState& said) : said_(said) {}
  const ArmState& state() const override { return said_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& /*setpoint_kpa*/) override {
    return said_;
  }
  void vent() noexcept override {}

 private:
  ArmState said_;
};

TEST_F(GatedDriverTest, AStateOfAnotherArmIsAFault) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const Backbone straight = Backbone::Zero(arm_.point_count(), 3);
  const ArmState right{0.0, Pressures::Zero(2), {}, straight};
  const auto fault_of = [&](const ArmState& said) {
    SayingArm driver(said);
    GatedDriver gated(arm_, driver, true);
    try {
      (void)gated.state();
      (void)gated.command(Pressures::Zero(2));
    } catch (const SystemFault& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault_of(right), "");
  ArmState wrong = right;
  wrong.pressure_kpa = Pressures::Zero(3);
  EXPECT_THAT(fault_of(wrong), HasSubstr("3 pressures and 5 backbone points"));
  wrong = right;
  wrong.backbone = Backbone(0, 3);
  EXPECT_THAT(fault_of(wrong), HasSubstr("2 pressures and 0 backbone points"));
  wrong = right;
  wrong.setpoint_kpa = Pressures::Zero(1);
  EXPECT_THAT(fault_of(wrong), HasSubstr("expected 2 and 5"));
  wrong = right;
  wrong.pressure_kpa[1] = none;
  EXPECT_THAT(fault_of(wrong), HasSubstr("not finite"));
  wrong = right;
  wrong.setpoint_kpa = Pressures::Constant(2, none);
  EXPECT_THAT(fault_of(wrong), HasSubstr("not finite"));
  wrong = right;
  wrong.time_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(fault_of(wrong), HasSubstr("not finite"));
}

TEST_F(GatedDriverTest, ABenchTestKeepsThemToo) {
  const ArmDescription one = small_arm(1);
  TrustingArm driver(one);
  Episode episode;
  EXPECT_THAT(
      [&] { (void)measure_segment(one, PressureLimits(150.0), 4, driver, episode); },
      ThrowsMessage<SystemFault>(AllOf(HasSubstr("segment 0"), HasSubstr("It was not sent"))));
  EXPECT_LE(driver.largest_kpa, kLimitKpa + kRoundingKpa);
}

}  // namespace
}  // namespace limber
