// What is said of runs that did not arrive, and what is not known of those that were not seen.
#include <cmath>

#include <gmock/gmock.h>

#include "limber/run/executor.hpp"
#include "limber/run/plan_controller.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kUnseen_s = 0.25;  // so long before the end an arm may have been seen last

/// The executed plan bends the arm for 16 frames, and its end is held for 20.
class RunMessage : public ::testing::Test {
 protected:
  void SetUp() override {
    environment_.name = "test";
    const Plan plan = bending_plan(arm_, environment_);
    end_ = tip_pose(plan.frames.back().backbone);
    environment_.goal = {end_.x_m, end_.y_m, end_.theta_rad, 0.02, 0.3};
  }

  Plan plan() const {
    Plan plan = bending_plan(arm_, environment_);
    plan.goal_distance_m = 0.004;
    return plan;
  }

  ExecutionResult run(const FakeFaults& faults = {}, Controller* source = nullptr) {
    FakeArm driver(arm_, kInstant_s, faults);
    ExecutionSettings settings;
    settings.controller = source;
    return execute(arm_, environment_, plan(), driver, settings);
  }

  double run_s() { return run().frames * arm_.frame_period_s(); }

  /// A circle that the tip of the arm bends into.
  void add_obstacle() { environment_.obstacles = {Circle{0.33, -0.10, 0.02}}; }

  ArmDescription arm_ = small_arm();
  Environment environment_;
  Pose end_;
};

/// A change of the arm that a run may believe in.
ArmChange load_of_60_g() {
  return {{"tip_load_kg", 0.060, 0.004, 0.002}};
}

/// As many plans as asked, each a frame of standing still.
class Stays final : public PlanController {
 public:
  explicit Stays(int plans, bool halts = false) : left_(plans), halts_(halts) {}
  bool may_go_on(const Plan&, std::size_t seen, const ArmEstimate&) override {
    return !halts_ || seen < 3;
  }
  NextPlan next(const PlanProgress& at, const ArmEstimate&) override {
    if (left_-- <= 0) {
      return {};
    }
    Plan stay = at.plan;
    stay.frames.assign(2, at.plan.frames[at.frame]);
    stay.waypoints_kpa.assign(2, at.sent_kpa);
    stay.hold_frame_count = 0;
    return [stay] { return FollowedPlan{stay, {}}; };
  }
  std::function<MotionAdvice()> advise(const PlanProgress& at, const ArmEstimate&) override {
    const bool stops = !stop_reason.empty() && at.frame == 3;
    return [stops, reason = stop_reason] {
      return stops ? MotionAdvice{MotionAdvice::Kind::stop, std::nullopt, reason} : MotionAdvice{};
    };
  }
  void report(ExecutionResult& result) const override {
    PlanController::report(result);
    result.arm_changes = believed;
  }

  std::string stop_reason;
  std::vector<ArmChange> believed;

 private:
  int left_;
  bool halts_;
};

TEST_F(RunMessage, IsEmptyWhereTheArmArrived) {
  const ExecutionResult result = run();
  EXPECT_TRUE(has_arrived(result));
  EXPECT_EQ(result.message, "");
  EXPECT_EQ(result.frames_not_seen, 0);
}

TEST_F(RunMessage, SaysHowFarFromTheGoalItEnded) {
  environment_.goal.x_m += 0.03;
  environment_.goal.y_m += 0.04;
  EXPECT_THAT(run().message,
              AllOf(HasSubstr("ended 5.0 cm from the goal (2.0 cm allowed): its plan "
                              "has it 0.4 cm from there"),
                    HasSubstr("--replan")));
  *environment_.goal.theta_rad += 0.5;
  EXPECT_THAT(run().message,
              HasSubstr("ended 5.0 cm and 0.50 rad from the goal (2.0 cm and 0.30 rad allowed)"));
  environment_.goal.position_tolerance_m = 0.06;
  EXPECT_THAT(run().message,
              HasSubstr("ended 0.50 rad from the goal's heading (0.30 rad allowed)"));
}

TEST_F(RunMessage, NamesWhatWasStruckOnTheWayToTheGoal) {
  add_obstacle();
  const ExecutionResult result = run();
  EXPECT_TRUE(result.goal_reached && result.collided);
  EXPECT_FALSE(has_arrived(result));
  EXPECT_THAT(result.message, AllOf(HasSubstr("collided with obstacle 0 (circle), plates "),
                                    HasSubstr(" after 0."), Not(HasSubstr("from the goal"))));
}

TEST_F(RunMessage, CountsThePlansOfAClosedLoop) {
  environment_.goal.x_m += 0.05;
  Stays many(24);
  EXPECT_THAT(
      run({}, &many).message,
      HasSubstr("24 plans from rest, none came into it; friction or load may have changed"));
  Stays none(0);
  EXPECT_THAT(run({}, &none).message, HasSubstr("no plan from where it rests leads nearer"));
  Stays halts(0, true);
  const ExecutionResult halted = run({}, &halts);
  EXPECT_TRUE(halted.stopped_ahead);
  EXPECT_THAT(halted.message, HasSubstr("halted on its way, and no plan leads on from there"));
}

TEST_F(RunMessage, SaysWhatIsBelievedOfTheArmHoweverTheRunEnded) {
  const std::string believed =
      "; what may have changed of the arm (in brackets, before): "
      "load at the tip 60.0 ± 4.0 g (2.0)";
  const auto ended = [&](int plans, bool halts, const FakeFaults& faults = {},
                         const std::string& stop_reason = "") {
    Stays stays(plans, halts);
    stays.stop_reason = stop_reason;
    stays.believed = {load_of_60_g()};
    const ExecutionResult result = run(faults, &stays);
    EXPECT_THAT(result.hint, EndsWith(believed));
    return result.message;
  };
  EXPECT_EQ(ended(0, false), "") << "one that arrived has nothing to explain";
  environment_.goal.x_m += 0.05;
  EXPECT_THAT(ended(1, false), EndsWith("1 plan from rest, none came into it" + believed));
  EXPECT_THAT(ended(0, false), EndsWith("no plan from where it rests leads nearer" + believed));
  EXPECT_THAT(ended(0, true), EndsWith("and no plan leads on from there" + believed));
  EXPECT_EQ(ended(0, false, {}, "obstacle 3 (circle) is in the way"),
            "obstacle 3 (circle) is in the way" + believed);
  FakeFaults faults;
  faults.lost_from_s = 0.5;
  EXPECT_THAT(ended(0, false, faults), EndsWith("arrival and collisions are unknown" + believed));
  faults.fails_at_s = 0.5;
  EXPECT_THAT(ended(0, false, faults), EndsWith("hose came off at 0.50 s" + believed));
}

TEST_F(RunMessage, NamesTheObstacleThatAHaltedArmIsNearestTo) {
  environment_.goal.x_m += 0.05;
  environment_.obstacles = {Circle{0.2, 0.9, 0.02}, Circle{0.3, 0.2, 0.02}};
  Stays halts(0, true);
  EXPECT_THAT(
      run({}, &halts).message,
      ContainsRegex("halted on its way [0-9]+\\.[0-9] cm from obstacle 1 \\(circle\\), and"));
}

TEST_F(RunMessage, OfAnArmThatIsNotSeenAnyMoreSaysThatItIsUnknown) {
  FakeFaults lost;
  lost.lost_from_s = 0.5;
  const ExecutionResult result = run(lost);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_FALSE(result.final_backbone);
  EXPECT_FALSE(result.goal_reached);
  EXPECT_FALSE(result.goal_time_s);
  EXPECT_TRUE(std::isnan(result.prediction->final_m));
  EXPECT_EQ(result.frames_not_seen, 36 - 9);
  EXPECT_EQ(result.message,
            "the arm was not seen at the end (27 of 36 frames without it): arrival and collisions "
            "are unknown");
  EXPECT_EQ(result.episode.frame_count(), 37) << "what was measured is kept";
}

TEST_F(RunMessage, DoesNotForgetACollisionThatWasSeen) {
  add_obstacle();
  FakeFaults lost;
  lost.lost_from_s = 0.8;
  const ExecutionResult result = run(lost);
  EXPECT_TRUE(result.collided && result.closest);
  EXPECT_FALSE(result.final_backbone);
  EXPECT_THAT(result.message, AllOf(HasSubstr("collided with obstacle 0"),
                                    HasSubstr("whether it arrived is unknown")));
  lost.lost_from_s = 0.2;
  const ExecutionResult before = run(lost);
  EXPECT_FALSE(before.collided || before.closest);
}

TEST_F(RunMessage, AQuarterOfASecondUnseenIsNotTooLong) {
  const double end_s = run_s();
  FakeFaults lost;
  lost.lost_from_s = end_s - kUnseen_s + 0.5 * arm_.frame_period_s();  // seen five frames before
  const ExecutionResult seen = run(lost);
  EXPECT_EQ(seen.frames_not_seen, 5);
  EXPECT_TRUE(has_arrived(seen));
  EXPECT_EQ(seen.message, "");
  lost.lost_from_s -= arm_.frame_period_s();
  EXPECT_FALSE(run(lost).final_backbone);
}

TEST_F(RunMessage, OfAnArmThatIsNeverSeenSaysSo) {
  FakeFaults faults;
  faults.drop_every = 1;
  EXPECT_THAT(run(faults).message, HasSubstr("the arm was not seen at all (36 of 36 frames"));
}

TEST_F(RunMessage, TheTruthOfAVirtualArmIsKnownThoughNothingTracksIt) {
  VirtualArmOptions options;
  options.drop_rate = 1.0;
  VirtualArm driver(arm_, options);
  const ExecutionResult result = execute(arm_, environment_, plan(), driver);
  EXPECT_TRUE(result.final_backbone);
  EXPECT_EQ(result.frames_not_seen, result.frames);
}

}  // namespace
}  // namespace limber
