#include <functional>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/plan_controller.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kHaltS = 0.3;  // for which an arm that was halted is held

/// Halts once, in frame 3, and goes on with one more plan.
class HaltOnce final : public PlanController {
 public:
  explicit HaltOnce(std::function<Plan(const Pressures&)> plan_from)
      : plan_from_(std::move(plan_from)) {}
  bool may_go_on(const Plan&, std::size_t seen, const ArmEstimate&) override {
    return halted_ || seen < 3;
  }
  NextPlan next(const PlanProgress& at, const ArmEstimate&) override {
    if (std::exchange(halted_, true)) {
      return {};
    }
    return [this, held_kpa = at.sent_kpa] { return FollowedPlan{plan_from_(held_kpa), {}}; };
  }

 private:
  std::function<Plan(const Pressures&)> plan_from_;
  bool halted_ = false;
};

TEST(PlanController, HoldsWhereItHaltsAndGoesOnFromThere) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  HaltOnce source([&](const Pressures& setpoint_kpa) {
    EXPECT_EQ(setpoint_kpa, plan.frames[3].setpoint_kpa);
    Plan rest = plan;
    rest.frames.erase(rest.frames.begin(), rest.frames.begin() + 3);
    return rest;
  });
  ExecutionSettings settings;
  settings.controller = &source;
  settings.hold_s = 0.5;
  FakeArm driver(arm, kInstant_s);
  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  EXPECT_EQ(result.halts, 1);
  EXPECT_EQ(result.replans, 1);
  EXPECT_EQ(result.frames, plan.frame_count() - 1 + arm.frames_in(kHaltS) + arm.frames_in(0.5));
  EXPECT_EQ(result.episode.setpoint_kpa.row(3 + arm.frames_in(kHaltS)),
            plan.frames[3].setpoint_kpa.transpose());
}

TEST(PlanController, RefusesANextPlanThatStartsElsewhereAndVents) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  HaltOnce source([&](const Pressures&) { return plan; });
  ExecutionSettings settings;
  settings.controller = &source;
  int vents = 0;
  FakeArm driver(arm, kInstant_s, {}, &vents);
  EXPECT_THAT([&] { (void)execute(arm, environment, plan, driver, settings); },
              ThrowsMessage<InputError>(HasSubstr("does not start at the set points")));
  EXPECT_GE(vents, 1);
}

/// Adds to the set points of one frame.
class Trims final : public PlanController {
 public:
  Trims(std::size_t frame, float more_kpa) : frame_(frame), more_kpa_(more_kpa) {}
  FrameSetpoint setpoint(const PlanProgress& at, std::size_t next, const ArmEstimate&) override {
    if (at.frame == frame_) {
      shown_kpa = at.sent_kpa;
    }
    Pressures kpa = at.setpoint_kpa(next);
    if (next == frame_ && at.frame != frame_) {
      kpa[1] += more_kpa_;
    }
    return {kpa, next};
  }

  Pressures shown_kpa;

 private:
  std::size_t frame_;
  float more_kpa_;
};

TEST(PlanController, DecidesTheSetPointsOfAFrameAndIsShownThemWhileThePlanStays) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  Trims source(3, 2.0F);
  ExecutionSettings settings;
  settings.controller = &source;
  FakeArm driver(arm, kInstant_s);
  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  EXPECT_TRUE(plan.frames[3].setpoint_kpa == bending_plan(arm, environment).frames[3].setpoint_kpa);
  const Pressures sent = plan.frames[3].setpoint_kpa + Eigen::Vector2f(0.0F, 2.0F);
  EXPECT_EQ(result.episode.setpoint_kpa.row(3), sent.transpose());
  EXPECT_EQ(source.shown_kpa, sent);
  EXPECT_EQ(result.episode.setpoint_kpa.row(4), plan.frames[4].setpoint_kpa.transpose());
}

TEST(PlanController, RunsOnceAndSaysSo) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  Trims controller(3, 0.0F);
  ExecutionSettings settings;
  settings.controller = &controller;
  FakeArm driver(arm, kInstant_s);
  (void)execute(arm, environment, plan, driver, settings);
  FakeArm again(arm, kInstant_s);
  EXPECT_THAT([&] { (void)execute(arm, environment, plan, again, settings); },
              ThrowsMessage<InputError>(HasSubstr("runs once")));
}

TEST(PlanController, RefusesSetPointsThatAreTooFastAndVents) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  Trims source(3, float(arm.pressure_step_limit_kpa()) + 1.0F);
  ExecutionSettings settings;
  settings.controller = &source;
  int vents = 0;
  FakeArm driver(arm, kInstant_s, {}, &vents);
  EXPECT_THAT([&] { (void)execute(arm, environment, plan, driver, settings); },
              ThrowsMessage<InputError>(HasSubstr("a frame allows")));
  EXPECT_GE(vents, 1);
}

}  // namespace
}  // namespace limber
