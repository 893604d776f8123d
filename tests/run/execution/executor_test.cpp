#include "limber/run/executor.hpp"

#include <csignal>
#include <cstdlib>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/straight_motion.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Executor : public ::testing::Test {
 protected:
  void SetUp() override {
    environment_.name = "test";
    const Plan plan = bending_plan(arm_, environment_);
    const Pose end = tip_pose(plan.frames.back().backbone);
    environment_.goal.x_m = end.x_m + 0.03;
    environment_.goal.y_m = end.y_m + 0.04;
    environment_.goal.theta_rad = end.theta_rad + 0.2;
    environment_.goal.position_tolerance_m = 0.06;
    environment_.goal.orientation_tolerance_rad = 0.3;
  }

  Plan plan() const {
    Plan plan = bending_plan(arm_, environment_);
    plan.model = "no_load";
    return plan;
  }

  /// A circle that the tip of the arm bends into.
  void add_obstacle(double y_m) { environment_.obstacles = {Circle{0.33, y_m, 0.02}}; }

  ArmDescription arm_ = small_arm();
  Environment environment_;
};

TEST_F(Executor, CommandsEveryFrameThenHoldsOneSecond) {
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_EQ(result.frames, 16 + 20);  // 8 frames an edge; 1.0 s at 20 Hz
  ASSERT_EQ(result.episode.frame_count(), 37);
  const Plan expected = plan();
  for (int k = 0; k < 37; ++k) {
    const auto planned = std::size_t(std::min(k, 16));
    EXPECT_EQ(result.episode.setpoint_kpa.row(k).transpose(),
              expected.frames[planned].setpoint_kpa);
    EXPECT_EQ(result.episode.motion_index[std::size_t(k)], k <= 8 ? 0 : 1) << k;
  }
}

/// A fake arm that says that its frames take their time.
class PunctualArm final : public ArmDriver {
 public:
  explicit PunctualArm(const ArmDescription& arm) : arm_(arm, kInstant_s) {}
  const ArmState& state() const override { return arm_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& kpa) override {
    return arm_.command(kpa);
  }
  bool is_real_time() const override { return true; }
  void vent() noexcept override { arm_.vent(); }

 private:
  FakeArm arm_;
};

TEST_F(Executor, HoldsAsLongAsItIsAskedToAndTellsOfTheStartAndEveryFrame) {
  PunctualArm driver(arm_);
  ExecutionSettings settings;
  std::vector<Pressures> told;
  std::vector<double> told_kpa;  // measured in the first segment
  settings.should_hold = [&told] { return told.size() >= 6 && told.size() < 13; };
  settings.on_frame = [&](const ExecutedFrame& frame) {
    EXPECT_NEAR(frame.time_s, double(told.size()) * arm_.frame_period_s(), 1e-9);
    told.push_back(frame.setpoint_kpa);
    told_kpa.push_back(double(frame.state.pressure_kpa[0]));
  };
  const ExecutionResult result = execute(arm_, environment_, plan(), driver, settings);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  ASSERT_EQ(told.size(), 1U + 16U + 7U + 20U);
  const Plan planned = plan();
  for (std::size_t k = 0; k < told.size(); ++k) {
    const std::size_t frame = k < 6 ? k : k < 13 ? 5 : std::min<std::size_t>(k - 7, 16);
    EXPECT_EQ(told[k], planned.frames[frame].setpoint_kpa) << k;
  }
  EXPECT_EQ(told_kpa.front(), 0.0) << "before the first set points";
  EXPECT_NEAR(result.prediction->max_m, 0.0, 1e-6) << "held frames are compared with nothing";
}

TEST_F(Executor, CountsThePlansOwnHold) {
  Plan holding = plan();
  for (int k = 0; k < 15; ++k) {
    holding.frames.push_back(holding.frames.back());
  }
  holding.hold_frame_count = 15;
  FakeArm driver(arm_, kInstant_s);
  EXPECT_EQ(execute(arm_, environment_, holding, driver).frames, 16 + 20);
  FakeArm again(arm_, kInstant_s);
  ExecutionSettings no_more;
  no_more.hold_s = 0.0;
  EXPECT_EQ(execute(arm_, environment_, holding, again, no_more).frames, 16 + 15);
}

TEST_F(Executor, MeasuresTheGoalAfterTheHold) {
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_NEAR(result.goal_error.position_m, 0.05, 1e-6);
  EXPECT_NEAR(result.goal_error.orientation_rad, 0.2, 1e-6);
  EXPECT_TRUE(result.goal_reached);
  environment_.goal.position_tolerance_m = 0.04;
  FakeArm again(arm_, kInstant_s);
  EXPECT_FALSE(execute(arm_, environment_, plan(), again).goal_reached);

  FakeArm slow(arm_, 0.3);  // 95 % there after the hold's first 0.9 s
  const ExecutionResult late = execute(arm_, environment_, plan(), slow);
  EXPECT_GT(late.prediction->final_m, 0.01);
  EXPECT_GT(late.prediction->max_m, late.prediction->mean_m);
  EXPECT_NEAR(late.goal_error.position_m, 0.05, 0.01);
}

TEST_F(Executor, FindsNoErrorOfAModelThatIsTrue) {
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  ASSERT_TRUE(result.prediction);
  EXPECT_NEAR(result.prediction->max_m, 0.0, 1e-6);
  EXPECT_NEAR(result.start_error_m, 0.0, 1e-7);
}

TEST_F(Executor, RefusesASettingThatWouldSwitchTheStartCheckOff) {
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), -0.01}) {
    FakeArm driver(arm_, kInstant_s);
    ExecutionSettings settings;
    settings.max_start_error_m = wrong;
    EXPECT_THAT([&] { (void)execute(arm_, environment_, plan(), driver, settings); },
                ThrowsMessage<InputError>(HasSubstr("max_start_error_m = ")));
  }
}

TEST_F(Executor, ReportsNoClearanceWithoutObstacles) {
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_FALSE(result.collided);
  EXPECT_FALSE(result.closest);
}

TEST_F(Executor, NamesFirstCollisionAndClosestMoment) {
  add_obstacle(-0.10);
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  ASSERT_TRUE(result.collided);
  EXPECT_EQ(result.status, ExecutionStatus::done) << "obstacles exert no force";

  // Oracle: every frame by the checker itself.
  const CollisionChecker checker(arm_, environment_.obstacles);
  double smallest = 1e9;
  int first = -1;
  int closest = -1;
  for (int t = 0; t < result.episode.frame_count(); ++t) {
    const Backbone backbone =
        Eigen::Map<const Backbone>(result.episode.backbone.row(t).data(), arm_.point_count(), 3);
    const double value = checker.clearance(backbone).value_m;
    first = first < 0 && value < 0.0 ? t : first;
    if (value < smallest) {
      smallest = value;
      closest = t;
    }
  }
  EXPECT_NEAR(result.first_collision->time_s, first * arm_.frame_period_s(), 1e-9);
  EXPECT_EQ(result.first_collision->clearance.obstacle, 0);
  EXPECT_GE(result.first_collision->clearance.gap, 2) << "the far segment";
  constexpr double kSlackM = 1.1e-4;
  EXPECT_NEAR(result.closest->clearance.value_m, smallest, kSlackM);
  EXPECT_NEAR(result.closest->time_s, closest * arm_.frame_period_s(), 0.051);
}

TEST_F(Executor, IsFreeBesideAnObstacle) {
  add_obstacle(0.10);
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_FALSE(result.collided);
  EXPECT_NEAR(result.closest->clearance.value_m, 0.10 - 0.02 - 0.026, 0.0011);  // straight, start
  EXPECT_EQ(result.closest->time_s, 0.0);
}

TEST_F(Executor, VentsAndReportsAFault) {
  FakeFaults faults;
  faults.fails_at_s = 0.5;
  int vents = 0;
  FakeArm driver(arm_, kInstant_s, faults, &vents);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_EQ(result.status, ExecutionStatus::fault);
  EXPECT_THAT(result.message, HasSubstr("hose came off at 0.50 s"));
  EXPECT_EQ(result.frames, 9);
  EXPECT_FALSE(result.goal_reached);
  EXPECT_EQ(result.episode.frame_count(), 10) << "what was recorded before is kept";
  EXPECT_GE(vents, 1);
}

TEST_F(Executor, VentsAndStopsOnCtrlC) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        install_interrupt_handler();
        int vents = 0;
        FakeArm driver(arm_, kInstant_s, {}, &vents);
        std::raise(SIGINT);
        const ExecutionResult result = execute(arm_, environment_, plan(), driver);
        const bool right = result.status == ExecutionStatus::stopped && result.frames == 0 &&
                           vents == 1 && !result.goal_reached;
        std::fputs(result.message.c_str(), stderr);
        std::exit(right ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "stopped on request after 0 frames");
}

TEST_F(Executor, VentsAndStopsWhereItsCallerAsksTo) {
  int vents = 0;
  FakeArm driver(arm_, kInstant_s, {}, &vents);
  int asked = 0;
  ExecutionSettings settings;
  settings.should_stop = [&] { return ++asked > 5; };
  const ExecutionResult result = execute(arm_, environment_, plan(), driver, settings);
  EXPECT_EQ(result.status, ExecutionStatus::stopped);
  EXPECT_EQ(result.frames, 5);
  EXPECT_GE(vents, 1);
}

TEST_F(Executor, TreatsNumbersThatAreNotFiniteAsAFault) {
  FakeFaults faults;
  faults.returns_nan_at_s = 0.3;
  int vents = 0;
  FakeArm driver(arm_, kInstant_s, faults, &vents);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_EQ(result.status, ExecutionStatus::fault);
  EXPECT_THAT(result.message, HasSubstr("not finite"));
  EXPECT_GE(vents, 1);
}

TEST_F(Executor, KnowsNothingOfAnArmThatNothingTracks) {
  FakeFaults faults;
  faults.drop_every = 1;
  FakeArm driver(arm_, kInstant_s, faults);
  add_obstacle(-0.10);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_FALSE(result.final_backbone);
  EXPECT_FALSE(result.goal_reached);
  EXPECT_FALSE(result.closest);
  EXPECT_FALSE(result.prediction);
  EXPECT_EQ(result.episode.frame_count(), 0);
}

TEST_F(Executor, RecordsNothingOfAnArmWhoseFirstSampleIsRepeatedForEver) {
  /// Not seen at first; what it says later is of the same time.
  class StoppedClock final : public ArmDriver {
   public:
    explicit StoppedClock(const ArmDescription& arm) : arm_(arm, kInstant_s), now_(arm_.state()) {
      now_.backbone.reset();
    }
    const ArmState& state() const override { return now_; }
    const ArmState& command(const Eigen::Ref<const Pressures>& kpa) override {
      const double first_s = now_.time_s;
      now_ = arm_.command(kpa);
      now_.time_s = first_s;
      return now_;
    }
    void vent() noexcept override { arm_.vent(); }

   private:
    FakeArm arm_;
    ArmState now_;
  };
  StoppedClock driver(arm_);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_GT(result.frames, 0);
  EXPECT_EQ(result.frames_not_seen, result.frames);
  EXPECT_EQ(result.episode.frame_count(), 0);
}

TEST_F(Executor, VentsWhenADriverRefuses) {
  class Refusing final : public ArmDriver {
   public:
    explicit Refusing(const ArmDescription& arm) : arm_(arm, kInstant_s) {}
    const ArmState& state() const override { return arm_.state(); }
    const ArmState& command(const Eigen::Ref<const Pressures>&) override { throw InputError("no"); }
    void vent() noexcept override { vented = true; }
    bool vented = false;

   private:
    FakeArm arm_;
  };
  Refusing driver(arm_);
  EXPECT_THROW((void)execute(arm_, environment_, plan(), driver), InputError);
  EXPECT_TRUE(driver.vented);
}

TEST_F(Executor, RefusesAPlanOfAnotherEnvironmentOrArm) {
  const Plan made = plan();
  FakeArm driver(arm_, kInstant_s);
  Environment moved = environment_;
  moved.obstacles = {Circle{1.0, 1.0, 0.1}};
  EXPECT_THAT([&] { (void)execute(arm_, moved, made, driver); },
              ThrowsMessage<InputError>(HasSubstr("made for environment 'test' (hash ")));
  ArmDescription wider = arm_;
  wider.segments[0].width_m = 0.05;
  EXPECT_THAT([&] { (void)execute(wider, environment_, made, driver); },
              ThrowsMessage<InputError>(HasSubstr("plan: arm_hash: made for arm 'small'")));
  Plan empty = made;
  empty.frames.clear();
  EXPECT_THAT([&] { (void)execute(arm_, environment_, empty, driver); },
              ThrowsMessage<InputError>(HasSubstr("no frames")));
  EXPECT_EQ(driver.state().time_s, 0.0) << "the arm did not move";
}

TEST_F(Executor, SeesEveryStepOfTheVirtualArm) {
  add_obstacle(-0.10);
  VirtualArm driver(arm_);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  ASSERT_TRUE(result.closest);
  // Oracle: the same motion again, every step checked.
  VirtualArm again(arm_);
  const CollisionChecker checker(arm_, environment_.obstacles);
  double smallest = 1e9;
  double first_s = -1.0;
  again.set_observer([&](double time_s, const BackboneD& backbone) {
    const double value = checker.clearance(backbone).value_m;
    smallest = std::min(smallest, value);
    first_s = first_s < 0.0 && value < 0.0 ? time_s : first_s;
  });
  const Plan made = plan();
  for (std::size_t k = 1; k < made.frames.size(); ++k) {
    again.command(made.frames[k].setpoint_kpa);
  }
  again.settle(made.frames.back().setpoint_kpa, 1.0);
  EXPECT_NEAR(result.closest->clearance.value_m, smallest, 1.1e-4);
  EXPECT_EQ(result.collided, first_s >= 0.0);
  if (result.collided) {
    EXPECT_EQ(result.first_collision->time_s, first_s);
  }
  EXPECT_EQ(result.final_backbone->cast<double>(),
            again.true_backbone().cast<float>().cast<double>());
}

TEST_F(Executor, ApproachesAStartUnderPressureUnrecorded) {
  add_obstacle(-0.10);
  Plan reversed = plan();
  std::reverse(reversed.frames.begin(), reversed.frames.end());
  std::reverse(reversed.waypoints_kpa.begin(), reversed.waypoints_kpa.end());
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment_, reversed, driver);
  EXPECT_EQ(result.episode.time_s[0], 0.0);
  EXPECT_NEAR(result.episode.pressure_kpa(0, 0), 80.0F, 1e-3F);
  EXPECT_EQ(result.frames, 36);
  EXPECT_NEAR(result.start_error_m, 0.0, 1e-6);
}

TEST_F(Executor, DrawsRunPredictionAndCollision) {
  add_obstacle(-0.10);
  FakeArm driver(arm_, 0.2);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  const std::string svg = execution_picture(arm_, environment_, plan(), result);
  EXPECT_THAT(svg, HasSubstr("test: done, "));
  EXPECT_THAT(svg, HasSubstr(", collided"));
  EXPECT_THAT(svg, HasSubstr("first collision, "));
  EXPECT_THAT(svg, HasSubstr("end that the no-load model predicts"));
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  ExecutionResult unseen;
  unseen.status = ExecutionStatus::fault;
  EXPECT_THAT(execution_picture(arm_, environment_, plan(), unseen), HasSubstr("test: fault"));
}

}  // namespace
}  // namespace limber
