#include "limber/run/closed_loop.hpp"
#include "limber/arm/arm_identity.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/controller.hpp"
#include "limber/world/collision.hpp"
#include "planning/play_model.hpp"
#include "support/bending_arms.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The fake arm bends by its own no-load model; limber knows that one, or a weaker one.
class ClosedLoopTest : public ::testing::Test {
 protected:
  ClosedLoopTest() {
    environment_.name = "a goal to the right";
    environment_.goal = goal_at(arm_, Pressures::Constant(2, 50.0F));
  }

  static ClosedLoopSettings few_queries() {
    ClosedLoopSettings settings;
    settings.corrections.queries = 2000;
    settings.corrections.max_replans = 2;
    settings.motion_queries = 1000;
    return settings;
  }

  /// It says what its arm is, as files do: then a slowed arm is the same arm.
  static CompensationModel network_of(const ArmDescription& arm) {
    CompensationModel model = play_network(arm, 0.0F);
    model.arm_description = identity_of(arm).description;
    return model;
  }

  /// @param rate_share  of the arm's rate, that the plan keeps to
  Plan plan_of(ArmDescription arm, double rate_share = 1.0) const {
    const ForwardModel forward(arm, network_of(arm));
    arm.pressure_rate_limit_kpa_per_s *= rate_share;
    PlannerLimits limits;
    limits.queries = 5000;
    const PlanResult result =
        make_planner("default", 1)->plan({arm, MotionModel(forward), environment_, 0.0}, limits, 1);
    EXPECT_TRUE(result.plan.has_value()) << result.reason;
    return result.plan.value_or(Plan{});
  }

  /// @param closed  none: open loop
  ExecutionResult run(const ArmDescription& arm, const Plan& plan, ArmDriver& driver,
                      const std::optional<ClosedLoopSettings>& closed) {
    const ForwardModel forward(arm, network_of(arm));
    const MotionModel model(forward);
    std::optional<ClosedLoop> loop;
    ExecutionSettings settings;
    if (closed) {
      settings.controller = &loop.emplace(arm, model, environment_, ErrorRoom{}, *closed, 1);
    }
    return execute(arm, environment_, plan, driver, settings);
  }

  const ArmDescription arm_ = slow(small_arm());
  Environment environment_;
};

TEST_F(ClosedLoopTest, WithAPerfectModelItGoesOnAsOpenLoopUntilThePlanEnds) {
  const Plan plan = plan_of(arm_);
  FakeArm one(arm_, kInstant_s);
  FakeArm other(arm_, kInstant_s);
  const ExecutionResult open_loop = run(arm_, plan, one, std::nullopt);
  const ExecutionResult closed = run(arm_, plan, other, few_queries());
  EXPECT_EQ(closed.switches, 0);
  EXPECT_EQ(closed.waits, 0);
  EXPECT_EQ(closed.halts, 0);
  // Led arms are sent the sum of the plan's set points and a trim, here one of rounding.
  constexpr float kRoundingKpa = 1e-3F;
  const Eigen::Index frames = plan.frame_count() - plan.hold_frame_count;
  EXPECT_LT(
      (closed.episode.setpoint_kpa.topRows(frames) - open_loop.episode.setpoint_kpa.topRows(frames))
          .cwiseAbs()
          .maxCoeff(),
      kRoundingKpa);
}

TEST_F(ClosedLoopTest, TheOneForUsersIsTheSameWithDefaultSettings) {
  const ArmDescription weaker = bending(arm_, 0.6);
  const Plan plan = plan_of(weaker);
  FakeArm one(arm_, kInstant_s);
  const ExecutionResult own = run(weaker, plan, one, ClosedLoopSettings{});
  const ForwardModel forward(weaker, play_network(weaker, 0.0F));
  const MotionModel model(forward);
  const auto made = make_closed_loop(weaker, model, environment_, ErrorRoom{}, 1);
  ExecutionSettings settings;
  settings.controller = made.get();
  FakeArm other(arm_, kInstant_s);
  const ExecutionResult theirs = execute(weaker, environment_, plan, other, settings);
  EXPECT_GT(own.replans + own.switches, 0);
  EXPECT_EQ(own.episode.setpoint_kpa, theirs.episode.setpoint_kpa);
}

TEST_F(ClosedLoopTest, KeepsLimitsAndFrameRuleWithAnArmThatBendsFartherThanItsModel) {
  const ArmDescription weaker = bending(arm_, 0.6);
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult closed = run(weaker, plan_of(weaker), driver, few_queries());
  EXPECT_GT(closed.replans, 0);
  const auto& setpoints = closed.episode.setpoint_kpa;
  const Eigen::Index last = setpoints.rows() - 1;
  EXPECT_LE(setpoints.cwiseAbs().maxCoeff(), 100.0F);
  EXPECT_LE((setpoints.bottomRows(last) - setpoints.topRows(last)).cwiseAbs().maxCoeff(),
            float(weaker.pressure_step_limit_kpa()) + 1e-3F);
}

TEST_F(ClosedLoopTest, KeepsThePlansOwnRateInCorrectionsToo) {
  const ArmDescription weaker = bending(arm_, 0.6);
  constexpr double kSlowed = 0.5;
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult closed = run(weaker, plan_of(weaker, kSlowed), driver, few_queries());
  EXPECT_GT(closed.replans, 0);
  const auto& setpoints = closed.episode.setpoint_kpa;
  const Eigen::Index last = setpoints.rows() - 1;
  EXPECT_LE((setpoints.bottomRows(last) - setpoints.topRows(last)).cwiseAbs().maxCoeff(),
            float(kSlowed * weaker.pressure_step_limit_kpa()) + 1e-3F);
}

/// Its device allows less than the arm's file.
class LimitedArm final : public ArmDriver {
 public:
  LimitedArm(const ArmDescription& arm, double limit_kpa)
      : inner_(arm, kInstant_s), limits_(arm.segments.size(), PressureLimits(limit_kpa)) {}
  const ArmState& state() const override { return inner_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    return inner_.command(setpoint_kpa);
  }
  std::vector<PressureLimits> limits_kpa() const override { return limits_; }
  void vent() noexcept override { inner_.vent(); }

 private:
  FakeArm inner_;
  std::vector<PressureLimits> limits_;
};

// The arm bends less than its model: whoever leads it would go on to more pressure.
TEST_F(ClosedLoopTest, KeepsToWhatTheDriverAllows) {
  const ArmDescription stronger = bending(arm_, 1.5);
  const Plan plan = plan_of(stronger);
  float planned_kpa = 0.0F;
  for (const PlanFrame& frame : plan.frames) {
    planned_kpa = std::max(planned_kpa, frame.setpoint_kpa.cwiseAbs().maxCoeff());
  }
  FakeArm free(arm_, kInstant_s);
  const ExecutionResult unlimited = run(stronger, plan, free, few_queries());
  ASSERT_GT(unlimited.episode.setpoint_kpa.cwiseAbs().maxCoeff(), planned_kpa + 1.0F);
  LimitedArm driver(arm_, planned_kpa + 1.0F);
  const ExecutionResult limited = run(stronger, plan, driver, few_queries());
  EXPECT_LE(limited.episode.setpoint_kpa.cwiseAbs().maxCoeff(), planned_kpa + 1.0F);
}

/// Nobody sees it from a frame on, for some frames.
class LosingArm final : public ArmDriver {
 public:
  LosingArm(const ArmDescription& arm, int from, int frames)
      : inner_(arm, kInstant_s), from_(from), until_(from + frames) {
    state_ = inner_.state();
    lose();
  }
  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    state_ = inner_.command(setpoint_kpa);
    ++frame_;
    lose();
    commanded_kpa.emplace_back(setpoint_kpa);
    return state_;
  }
  void vent() noexcept override {}

  std::vector<Pressures> commanded_kpa;

 private:
  void lose() {
    if (frame_ >= from_ && frame_ < until_) {
      state_.backbone.reset();
    }
  }

  FakeArm inner_;
  int from_, until_;
  int frame_ = 0;
  ArmState state_;
};

TEST_F(ClosedLoopTest, NeverTrackedItIsOpenLoopToTheBit) {
  const ArmDescription weaker = bending(arm_, 0.6);
  const Plan plan = plan_of(weaker);
  LosingArm driver(arm_, 0, 1000);
  const ExecutionResult result = run(weaker, plan, driver, few_queries());
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_EQ(result.switches + result.waits + result.halts + result.replans, 0);
  ASSERT_GE(driver.commanded_kpa.size() + 1, plan.frames.size());
  for (std::size_t k = 1; k <= driver.commanded_kpa.size(); ++k) {
    EXPECT_EQ(driver.commanded_kpa[k - 1],
              plan.frames[std::min(k, plan.frames.size() - 1)].setpoint_kpa)
        << k;
  }
}

TEST_F(ClosedLoopTest, LostForShortItGoesOnByPrediction) {
  const Plan plan = plan_of(arm_);
  LosingArm driver(arm_, 2, 3);
  const ExecutionResult result = run(arm_, plan, driver, few_queries());
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_EQ(result.switches + result.waits + result.halts, 0);
  EXPECT_TRUE(result.goal_reached);
}

TEST_F(ClosedLoopTest, LostForLongItGoesOnAsOpenLoopThenHoldsAndSaysSo) {
  const Plan plan = plan_of(arm_);
  ASSERT_GT(plan.frame_count() - plan.hold_frame_count, 8);
  ClosedLoopSettings settings = few_queries();
  settings.blind_s = 0.1;  // two frames
  for (const std::uint64_t queries : {settings.motion_queries, std::uint64_t{0}}) {
    SCOPED_TRACE(queries);
    settings.motion_queries = queries;
    LosingArm driver(arm_, 2, 1000);
    const ExecutionResult result = run(arm_, plan, driver, settings);
    EXPECT_EQ(result.status, ExecutionStatus::stopped);
    EXPECT_THAT(result.message, HasSubstr("not tracked for more than 0.1 s"));
    EXPECT_EQ(result.halts, 1);
    // Unseen in frames 2, 3 and 4: the question before frame 5 says stop, after frame 5.
    const std::size_t last = 5;
    for (std::size_t k = 1; k <= driver.commanded_kpa.size(); ++k) {
      EXPECT_EQ(driver.commanded_kpa[k - 1], plan.frames[std::min(k, last)].setpoint_kpa) << k;
    }
  }
}

TEST_F(ClosedLoopTest, SameSeedSameRunWhateverTheThreads) {
  const ArmDescription weaker = bending(arm_, 0.6);
  const Plan plan = plan_of(weaker);
  std::vector<Eigen::MatrixXf> runs;
  for (const int jobs : {1, 2}) {
    FakeArm driver(arm_, kInstant_s);
    ClosedLoopSettings settings = few_queries();
    settings.corrections.planner_jobs = jobs;
    runs.push_back(run(weaker, plan, driver, settings).episode.setpoint_kpa);
  }
  EXPECT_EQ(runs[0], runs[1]);
}

TEST_F(ClosedLoopTest, WithoutQueriesInMotionItPlansAtRestAlone) {
  const ArmDescription weaker = bending(arm_, 0.85);
  const Plan plan = plan_of(weaker);
  FakeArm driver(arm_, kInstant_s);
  ClosedLoopSettings settings = few_queries();
  settings.motion_queries = 0;
  const ExecutionResult result = run(weaker, plan, driver, settings);
  EXPECT_EQ(result.switches, 0);
  EXPECT_GT(result.replans, 0);
  EXPECT_TRUE(result.goal_reached);
}

TEST_F(ClosedLoopTest, RefusesAModelWithoutANetwork) {
  const ForwardModel no_load(arm_);
  const MotionModel model(no_load);
  EXPECT_THAT([&] { (void)make_closed_loop(arm_, model, environment_, ErrorRoom{}, 1); },
              ThrowsMessage<InputError>(HasSubstr("the closed loop needs a network")));
}

TEST_F(ClosedLoopTest, QueriesOfATimeAreWholeHundreds) {
  const ForwardModel forward(arm_, play_network(arm_, 0.0F));
  const MotionModel model(forward);
  const std::uint64_t queries = queries_within(0.001, arm_, model);
  EXPECT_GE(queries, 100U);
  EXPECT_EQ(queries % 100U, 0U);
}

}  // namespace
}  // namespace limber
