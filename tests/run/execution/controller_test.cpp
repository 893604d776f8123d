#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/controller.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/plan_controller.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// In steps of motors, say: beyond 32768, float32 has every 256th part of one.
TEST(FrameRule, AllowsWhatItMakesOfCommandsInLargeUnits) {
  constexpr double kStep = 1250.0 + 0.55 / 256.0;
  ArmDescription arm = small_arm();
  arm.pressure_rate_limit_kpa_per_s = kStep * arm.frame_rate_hz;
  for (Segment& segment : arm.segments) {
    segment.pressure_limit_kpa = 50000.0;
  }
  Pressures at = Pressures::Zero(2);
  for (int frame = 0; frame < 45; ++frame) {
    const Pressures next = within_frame_rule(arm, at, Eigen::Vector2d(5e4, -5e4));
    EXPECT_NO_THROW(require_frame_rule(arm, frame, at, next)) << frame;
    at = next;
  }
  EXPECT_EQ(at, Pressures(Eigen::Vector2f(5e4F, -5e4F)));
  EXPECT_THAT([&] { require_frame_rule(arm, 0, at, at - Pressures::Unit(2, 0) * 1251.0F); },
              ThrowsMessage<InputError>(HasSubstr("segment 0")));
}

/// Says what a function of the frame says.
class Scripted final : public Controller {
 public:
  explicit Scripted(std::function<std::optional<Pressures>(int)> script)
      : script_(std::move(script)) {}
  Decision step(const Moment& now) override {
    Decision decision;
    decision.setpoint_kpa = script_(frame_++);
    decision.plan = plan_;
    decision.frame = static_cast<std::size_t>(now.arm.frames()) + 1;
    return decision;
  }
  void begin(const RunStart& start) override { plan_ = &start.plan; }

 private:
  std::function<std::optional<Pressures>(int)> script_;
  int frame_ = 0;
  const Plan* plan_ = nullptr;
};

class ControllerTest : public ::testing::Test {
 protected:
  ExecutionResult run(std::function<std::optional<Pressures>(int)> script, int* vents = nullptr) {
    Scripted controller(std::move(script));
    ExecutionSettings settings;
    settings.controller = &controller;
    FakeArm driver(arm_, kInstant_s, {}, vents);
    return execute(arm_, environment_, plan_, driver, settings);
  }

  const ArmDescription arm_ = small_arm();  // 10 kPa a frame
  const Environment environment_{};
  const Plan plan_ = bending_plan(arm_, environment_);
};

TEST_F(ControllerTest, ThePlansOwnSetPointsGiveThePlansRun) {
  const ExecutionResult result = run([&](int k) -> std::optional<Pressures> {
    const auto next = static_cast<std::size_t>(k) + 1;
    return next < plan_.frames.size() ? std::optional<Pressures>(plan_.frames[next].setpoint_kpa)
                                      : std::nullopt;
  });
  FakeArm driver(arm_, kInstant_s);
  ExecutionSettings no_hold;
  no_hold.hold_s = 0.0;
  const ExecutionResult open = execute(arm_, environment_, plan_, driver, no_hold);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_EQ(result.frames, plan_.frame_count() - 1);
  EXPECT_EQ(result.episode.backbone, open.episode.backbone);
  EXPECT_EQ(result.goal_error.position_m, open.goal_error.position_m);
  ASSERT_TRUE(result.prediction);
  EXPECT_EQ(result.prediction->mean_m, open.prediction->mean_m);
}

TEST_F(ControllerTest, SetPointsOfAnotherArmAreRefusedAndTheArmIsVented) {
  for (const int size : {0, 1, 3}) {
    int vents = 0;
    EXPECT_THAT([&] { (void)run([=](int) { return Pressures(Pressures::Zero(size)); }, &vents); },
                ThrowsMessage<InputError>(HasSubstr(
                    fmt::format("{} set points in frame 0; arm 'small' has 2 segments", size))));
    EXPECT_GE(vents, 1);
  }
}

TEST_F(ControllerTest, SetPointsBeyondLimitOrStepAreRefusedByNameAndTheArmIsVented) {
  int vents = 0;
  EXPECT_THAT(
      [&] { (void)run([](int) { return Pressures(Pressures::Unit(2, 1) * 11.0F); }, &vents); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("segment 1 in frame 0 changes from 0 to 11"),
                                      HasSubstr("a frame allows 10 kPa"))));
  EXPECT_GE(vents, 1);
  EXPECT_THAT(
      [&] { (void)run([](int k) { return Pressures(Pressures::Unit(2, 0) * float(10 * k)); }); },
      ThrowsMessage<InputError>(HasSubstr("is 110 kPa; expected ± 100")));
  EXPECT_THAT(
      [&] { (void)run([](int) { return Pressures(Pressures::Constant(2, std::nanf(""))); }); },
      ThrowsMessage<InputError>(HasSubstr("expected ± 100")));
}

/// Follows the plan and knows the valves; in its third frame it notices something.
class Noticing final : public PlanController {
 public:
  explicit Noticing(const MotionModel& model) : model_(model) {}
  EstimateModel estimate_with() const override { return {&model_, std::nullopt}; }
  std::string take_notice() override { return ++asked_ == 3 ? "a bird sits on it" : ""; }

 private:
  const MotionModel& model_;
  int asked_ = 0;
};

/// Its second segment loses a tenth of its pressure from a frame of the hold on.
class LeakingArm final : public ArmDriver {
 public:
  static constexpr double kLag_s = 0.1;
  static constexpr int kFrom = 20;
  explicit LeakingArm(const ArmDescription& arm) : inner_(arm, kLag_s), state_(inner_.state()) {}
  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    state_ = inner_.command(setpoint_kpa);
    state_.pressure_kpa[1] *= ++frame_ < kFrom ? 1.0F : 0.9F;
    return state_;
  }
  void vent() noexcept override { inner_.vent(); }

 private:
  FakeArm inner_;
  ArmState state_;
  int frame_ = 0;
};

TEST_F(ControllerTest, WhatIsNoticedOfTheArmIsToldOnceWhileItMoves) {
  const SegmentValves valves{{LeakingArm::kLag_s, 300.0}, {LeakingArm::kLag_s, 300.0}, 0.0, 0.0};
  const ForwardModel forward(arm_);
  const MotionModel model(
      forward, ValveModel(arm_, ValveParameters{true, std::vector<SegmentValves>(2, valves)}));
  Noticing controller(model);
  std::vector<std::pair<double, std::string>> noticed;  // when, and what
  ExecutionSettings settings;
  settings.controller = &controller;
  settings.hold_s = 3.0;
  settings.on_frame = [&noticed](const ExecutedFrame& frame) {
    if (!frame.noticed.empty()) {
      noticed.emplace_back(frame.time_s, frame.noticed);
    }
  };
  LeakingArm driver(arm_);
  const ExecutionResult result = execute(arm_, environment_, plan_, driver, settings);
  ASSERT_EQ(noticed.size(), 2U);
  EXPECT_NEAR(noticed[0].first, 3 * arm_.frame_period_s(), 1e-9);
  EXPECT_EQ(noticed[0].second, "a bird sits on it");
  ASSERT_EQ(result.pressure_losses.size(), 1U);
  EXPECT_NEAR(noticed[1].first, result.pressure_losses[0].noticed_s, 1e-9) << "in that frame";
  EXPECT_THAT(noticed[1].second, HasSubstr("segment 1 lost "));
}

/// Asks whatever it is told, and sends what it has.
class Asking final : public Controller {
 public:
  explicit Asking(std::function<void()> question) : question_(std::move(question)) {}
  Decision step(const Moment& now) override {
    Decision decision;
    decision.setpoint_kpa = now.arm.setpoint_kpa();
    decision.question = question_;
    return decision;
  }

 private:
  std::function<void()> question_;
};

/// Each frame takes a millisecond.
class RealTimeArm final : public ArmDriver {
 public:
  RealTimeArm(const ArmDescription& arm, const FakeFaults& faults, int* vents)
      : inner_(arm, kInstant_s, faults, vents) {}
  const ArmState& state() const override { return inner_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return inner_.command(setpoint_kpa);
  }
  bool is_real_time() const override { return true; }
  void vent() noexcept override { inner_.vent(); }

 private:
  FakeArm inner_;
};

TEST_F(ControllerTest, ASecondQuestionIsRefusedAndTheArmIsVentedBeforeTheFirstIsAnswered) {
  int vents = 0;
  std::atomic<int> vents_when_answered = -1;
  Asking controller([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    vents_when_answered = vents;
  });
  ExecutionSettings settings;
  settings.controller = &controller;
  RealTimeArm driver(arm_, {}, &vents);
  EXPECT_THAT([&] { (void)execute(arm_, environment_, plan_, driver, settings); },
              ThrowsMessage<InputError>(HasSubstr("a second question")));
  EXPECT_GE(vents_when_answered, 1);
}

/// Asks once, and goes on holding what it has.
class AskingOnce final : public Controller {
 public:
  explicit AskingOnce(std::function<void()> question) : question_(std::move(question)) {}
  Decision step(const Moment& now) override {
    Decision decision;
    decision.setpoint_kpa = now.arm.setpoint_kpa();
    decision.question = std::exchange(question_, nullptr);
    return decision;
  }

 private:
  std::function<void()> question_;
};

// Else a run that has vented would not end before its search does.
TEST_F(ControllerTest, AFaultEndsTheQuestionThatIsWorkedOut) {
  FakeFaults faults;
  faults.fails_at_s = 0.25;
  std::atomic<bool> was_told = false;
  AskingOnce controller([&] {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!interrupt_requested() && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    was_told = interrupt_requested();
  });
  ExecutionSettings settings;
  settings.controller = &controller;
  int vents = 0;
  RealTimeArm driver(arm_, faults, &vents);
  EXPECT_EQ(execute(arm_, environment_, plan_, driver, settings).status, ExecutionStatus::fault);
  EXPECT_TRUE(was_told);
  EXPECT_FALSE(interrupt_requested()) << "of that thread alone";
}

TEST_F(ControllerTest, AFaultIsSaidWhateverAQuestionThrows) {
  FakeFaults faults;
  faults.fails_at_s = 0.05;  // the first frame
  std::atomic<bool> is_asked = false;
  Asking controller([&] {
    is_asked = true;
    throw InputError("the question's own");
  });
  ExecutionSettings settings;
  settings.controller = &controller;
  int vents = 0;
  RealTimeArm driver(arm_, faults, &vents);
  const ExecutionResult result = execute(arm_, environment_, plan_, driver, settings);
  EXPECT_TRUE(is_asked);
  EXPECT_EQ(result.status, ExecutionStatus::fault);
  EXPECT_THAT(result.message, HasSubstr("hose came off"));
}

}  // namespace
}  // namespace limber
