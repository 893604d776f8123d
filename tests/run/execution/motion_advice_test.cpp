// Plans that are replaced, waited with or left while the arm moves along them.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>
#include <utility>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/run/appearing_obstacle.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/plan_controller.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Advises what it is told to, and notes what it was shown.
class Adviser final : public PlanController {
 public:
  using Answer = std::function<MotionAdvice(const Plan& plan, std::size_t next)>;
  explicit Adviser(Answer answer) : answer_(std::move(answer)) {}

  void observe(const Moment& now) override {
    const ArmEstimate& arm = now.arm;
    if (arm.frames() == int(commanded_kpa.size())) {  // asked twice between frames
      commanded_kpa.push_back(arm.setpoint_kpa());
      times_s.push_back(arm.measured().time_s);
    }
  }
  std::function<MotionAdvice()> advise(const PlanProgress& at, const ArmEstimate&) override {
    asked_at.push_back(commanded_kpa.size() - 1);
    return [this, &plan = at.plan, next = at.frame] { return answer_(plan, next); };
  }

  void obstacle_appeared(const Environment&) override {
    told_while_thinking = told_while_thinking || is_thinking;
    told_after = commanded_kpa.size() - 1;
  }

  std::atomic<bool> is_thinking = false;  ///< set by answers that take a while
  bool told_while_thinking = false;
  std::optional<std::size_t> told_after;  ///< frames of the run, of the obstacle
  std::vector<Pressures> commanded_kpa;
  std::vector<double> times_s;
  std::vector<std::size_t> asked_at;  ///< frames of the run after which it was asked

 private:
  Answer answer_;
};

ExecutionSettings held_shortly() {
  ExecutionSettings settings;
  settings.hold_s = 0.5;
  return settings;
}

/// The rest of a plan from one of its frames on.
Plan rest_of(const Plan& plan, std::size_t frame) {
  Plan rest = plan;
  rest.frames.erase(rest.frames.begin(), rest.frames.begin() + std::ptrdiff_t(frame));
  rest.waypoints_kpa.front() = rest.frames.front().setpoint_kpa;
  return rest;
}

class MotionAdviceTest : public ::testing::Test {
 protected:
  ExecutionResult run(Adviser& adviser, ArmDriver& driver,
                      const AppearingObstacle* obstacle = nullptr) {
    ExecutionSettings settings = held_shortly();
    settings.controller = &adviser;
    settings.obstacle = obstacle;
    return execute(arm_, environment_, plan_, driver, settings);
  }
  ExecutionResult run(Adviser& adviser) {
    FakeArm driver(arm_, kInstant_s);
    return run(adviser, driver);
  }

  const ArmDescription arm_ = small_arm();
  const Environment environment_{};
  const Plan plan_ = bending_plan(arm_, environment_);
};

TEST_F(MotionAdviceTest, IsAskedForBeforeEachFrameOfAMotionAndShownEverySetPoint) {
  Adviser adviser([](const Plan&, std::size_t) { return MotionAdvice{}; });
  const ExecutionResult result = run(adviser);
  FakeArm blind(arm_, kInstant_s);
  const ExecutionResult open_loop = execute(arm_, environment_, plan_, blind, held_shortly());
  ASSERT_EQ(adviser.asked_at.size(), plan_.frames.size() - 1);
  for (std::size_t k = 0; k < adviser.asked_at.size(); ++k) {
    EXPECT_EQ(adviser.asked_at[k], k);
  }
  ASSERT_EQ(adviser.commanded_kpa.size(), std::size_t(result.frames) + 1);
  EXPECT_EQ(adviser.commanded_kpa.front(), plan_.frames.front().setpoint_kpa);
  EXPECT_EQ(result.episode.setpoint_kpa, open_loop.episode.setpoint_kpa);
  EXPECT_EQ(result.switches + result.waits + result.halts, 0);
}

TEST_F(MotionAdviceTest, TakesEffectInTheFrameAfterTheNext) {
  bool is_first = true;
  Adviser adviser([&](const Plan& plan, std::size_t next) {
    MotionAdvice advice;
    if (std::exchange(is_first, is_first && next != 4) && next == 4) {
      advice.plan = {rest_of(plan, 4), {}};
      advice.plan->plan.frames[1].setpoint_kpa[1] = 3.0F;  // tells it from the first plan
    }
    return advice;
  });
  const ExecutionResult result = run(adviser);
  EXPECT_EQ(result.switches, 1);
  EXPECT_EQ(result.replans, 0);
  EXPECT_EQ(adviser.commanded_kpa[4], plan_.frames[4].setpoint_kpa);
  EXPECT_EQ(adviser.commanded_kpa[5][1], 3.0F);
  EXPECT_EQ(adviser.commanded_kpa[6], plan_.frames[6].setpoint_kpa);
  EXPECT_EQ(result.frames, plan_.frame_count() - 1 + arm_.frames_in(0.5));
}

TEST_F(MotionAdviceTest, WaitingRepeatsAFrame) {
  int asked = 0;  // in its frame of waiting it is asked about frame 3 again
  Adviser twice([&](const Plan&, std::size_t next) {
    const bool waits = next == 3 && asked++ < 2;
    return MotionAdvice{waits ? MotionAdvice::Kind::wait : MotionAdvice::Kind::go_on};
  });
  const ExecutionResult result = run(twice);
  EXPECT_EQ(result.waits, 2);
  for (const std::size_t k : {3U, 4U, 5U}) {
    EXPECT_EQ(twice.commanded_kpa[k], plan_.frames[3].setpoint_kpa) << k;
  }
  EXPECT_EQ(twice.commanded_kpa[6], plan_.frames[4].setpoint_kpa);
  EXPECT_EQ(result.status, ExecutionStatus::done);
}

TEST_F(MotionAdviceTest, AStoppedArmHoldsAndSaysWhy) {
  Adviser adviser([](const Plan&, std::size_t next) {
    return next == 3 ? MotionAdvice{MotionAdvice::Kind::stop, std::nullopt, "no way"}
                     : MotionAdvice{};
  });
  const ExecutionResult result = run(adviser);
  EXPECT_EQ(result.status, ExecutionStatus::stopped);
  EXPECT_EQ(result.message, "no way");
  EXPECT_EQ(result.halts, 1);
  EXPECT_EQ(result.frames, 3 + arm_.frames_in(0.5)) << "the whole hold, as nothing was found";
  EXPECT_EQ(adviser.commanded_kpa.back(), plan_.frames[3].setpoint_kpa);
}

TEST_F(MotionAdviceTest, ARunThatIsStoppedAndRestsInTheGoalIsDone) {
  Environment there;
  const Pose tip = tip_pose(plan_.frames[3].backbone);
  there.goal = {tip.x_m, tip.y_m, std::nullopt, 0.02, 0.1};
  Plan plan = plan_;
  plan.environment_hash = environment_hash(there);
  for (const double hold_s : {1.0, 0.5}) {
    Adviser adviser([](const Plan&, std::size_t next) {
      return next == 3 ? MotionAdvice{MotionAdvice::Kind::stop, std::nullopt, "no way"}
                       : MotionAdvice{};
    });
    ExecutionSettings settings;
    settings.controller = &adviser;
    settings.hold_s = hold_s;
    FakeArm driver(arm_, kInstant_s);
    const ExecutionResult result = execute(arm_, there, plan, driver, settings);
    const bool rests = hold_s >= 1.0;  // a shorter hold does not show that it stays there
    EXPECT_EQ(result.halts, 1);
    EXPECT_EQ(result.goal_reached, rests);
    EXPECT_EQ(result.stopped_ahead, !rests);
    EXPECT_EQ(result.status, rests ? ExecutionStatus::done : ExecutionStatus::stopped);
  }
}

TEST_F(MotionAdviceTest, RefusesAPlanThatStartsElsewhereOrIsTooFastAndVents) {
  int vents = 0;
  const auto running = [&](const Plan& other) {
    Adviser adviser([&](const Plan&, std::size_t next) {
      MotionAdvice advice;
      if (next == 3) {
        advice.plan = {other, {}};
      }
      return advice;
    });
    FakeArm driver(arm_, kInstant_s, {}, &vents);
    (void)run(adviser, driver);
  };
  EXPECT_THAT([&] { running(plan_); },
              ThrowsMessage<InputError>(HasSubstr("does not start at the set points")));
  EXPECT_GE(vents, 1);
  Plan fast = rest_of(plan_, 3);
  fast.frames[1].setpoint_kpa[0] += 15.0F;
  EXPECT_THAT([&] { running(fast); }, ThrowsMessage<InputError>(HasSubstr("in one frame")));
}

/// In real time: each frame takes a while, whoever searches meanwhile.
class RealTimeArm final : public ArmDriver {
 public:
  RealTimeArm(const ArmDescription& arm, std::chrono::milliseconds frame)
      : inner_(arm, kInstant_s), frame_(frame) {}
  const ArmState& state() const override { return inner_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    std::this_thread::sleep_for(frame_);
    return inner_.command(setpoint_kpa);
  }
  bool is_real_time() const override { return true; }
  void vent() noexcept override {}

 private:
  FakeArm inner_;
  std::chrono::milliseconds frame_;
};

TEST_F(MotionAdviceTest, WhatComesLateIsDroppedAndDelaysNoFrame) {
  std::atomic<int> answers = 0;
  Adviser slow([&](const Plan& plan, std::size_t next) {
    ++answers;
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // several frames
    MotionAdvice advice;
    advice.plan = {rest_of(plan, next), {}};
    return advice;
  });
  RealTimeArm driver(arm_, std::chrono::milliseconds(5));
  const ExecutionResult result = run(slow, driver);
  EXPECT_EQ(result.switches, 0);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_GE(answers, 1);
  EXPECT_LT(answers, plan_.frame_count() - 1) << "nobody is asked while one is still thinking";
  EXPECT_EQ(result.advice.late, answers);
  ASSERT_EQ(result.advice.all_s.size(), std::size_t(answers));
  EXPECT_GE(*std::min_element(result.advice.all_s.begin(), result.advice.all_s.end()), 0.06);
}

TEST_F(MotionAdviceTest, InRealTimeNobodyIsToldOfAnObstacleWhileThinking) {
  Adviser slow([&](const Plan&, std::size_t) {
    slow.is_thinking = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(60));  // several frames
    slow.is_thinking = false;
    return MotionAdvice{};
  });
  RealTimeArm driver(arm_, std::chrono::milliseconds(5));
  const AppearingObstacle beside{1, {Circle{0.0, 1.0, 0.02}}};
  const ExecutionResult result = run(slow, driver, &beside);
  ASSERT_TRUE(result.appeared && slow.told_after);
  EXPECT_GT(*slow.told_after, 1U) << "it appeared while one was thinking";
  EXPECT_FALSE(slow.told_while_thinking);
}

TEST_F(MotionAdviceTest, NotesHowLongSearchesTookInRealTimeAlone) {
  const auto searching = [](const Plan&, std::size_t next) {
    return MotionAdvice{.has_searched = next % 2 == 0};
  };
  Adviser adviser(searching);
  RealTimeArm driver(arm_, std::chrono::milliseconds(5));
  const ExecutionResult result = run(adviser, driver);
  EXPECT_EQ(result.advice.all_s.size(), adviser.asked_at.size());
  EXPECT_GT(result.advice.searches_s.size(), 0U);
  EXPECT_LT(result.advice.searches_s.size(), result.advice.all_s.size());
  Adviser again(searching);
  EXPECT_TRUE(run(again).advice.all_s.empty());
}

TEST_F(MotionAdviceTest, InRealTimeWhatComesInTimeTakesEffect) {
  bool is_first = true;
  Adviser quick([&](const Plan& plan, std::size_t next) {
    MotionAdvice advice;
    if (std::exchange(is_first, is_first && next != 3) && next == 3) {
      advice.plan = {rest_of(plan, 3), {}};
    }
    return advice;
  });
  RealTimeArm driver(arm_, std::chrono::milliseconds(100));  // a loaded machine has time enough
  const ExecutionResult result = run(quick, driver);
  EXPECT_EQ(result.switches, 1);
  // While somebody still thinks at the end of the motion, the arm gets the set points it holds.
  EXPECT_GE(result.frames, plan_.frame_count() - 1 + arm_.frames_in(0.5));
}

TEST_F(MotionAdviceTest, SaysWhenTheTipWasInTheGoalForGood) {
  Environment environment = environment_;
  const Pose end = tip_pose(plan_.frames.back().backbone);
  environment.goal = {end.x_m, end.y_m, std::nullopt, 0.001, 0.1};
  Plan plan = plan_;
  plan.environment_hash = environment_hash(environment);
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = execute(arm_, environment, plan, driver, held_shortly());
  const double end_s = (plan.frame_count() - 1) * arm_.frame_period_s();
  constexpr double kRoundingS = 1e-9;
  ASSERT_TRUE(result.goal_time_s && result.planned_goal_time_s);
  EXPECT_NEAR(*result.planned_goal_time_s, end_s, kRoundingS);
  EXPECT_NEAR(*result.goal_time_s, end_s, kRoundingS);
  environment.goal.y_m += 0.1;
  plan.environment_hash = environment_hash(environment);
  FakeArm again(arm_, kInstant_s);
  const ExecutionResult missed = execute(arm_, environment, plan, again, held_shortly());
  EXPECT_FALSE(missed.goal_time_s || missed.planned_goal_time_s);
}

}  // namespace
}  // namespace limber
