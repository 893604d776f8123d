#include "limber/run/replanner.hpp"

#include <gtest/gtest.h>

#include "limber/planning/planner_factory.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "planning/play_model.hpp"
#include "support/bending_arms.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

/// The fake arm bends by its own no-load model, limber's knows a weaker one: open loop, plans end
/// off the goal.
class ReplannerTest : public ::testing::Test {
 protected:
  explicit ReplannerTest(double bends = 0.5) : known_(bending(arm_, bends)) {
    environment_.name = "a goal to the right";
    environment_.goal = goal_at(arm_, Pressures::Constant(2, 40.0F));
  }

  Plan open_loop_plan() const {
    PlannerLimits limits;
    limits.queries = 20000;
    const PlanResult result =
        make_planner("default", 1)->plan({known_, model_, environment_, 0.0}, limits, 1);
    EXPECT_TRUE(result.plan.has_value()) << result.reason;
    return result.plan.value_or(Plan{});
  }

  /// Corrected at rest alone. @param corrections  none: open loop
  ExecutionResult run(FakeArm& driver, const std::optional<ReplannerSettings>& corrections) {
    ClosedLoopSettings at_rest;
    at_rest.corrections = corrections.value_or(ReplannerSettings{});
    at_rest.motion_queries = 0;
    ClosedLoop loop(known_, model_, environment_, ErrorRoom{}, at_rest, 1);
    ExecutionSettings settings;
    settings.controller = corrections ? &loop : nullptr;
    return execute(known_, environment_, open_loop_plan(), driver, settings);
  }

  Replanner replanner(const ReplannerSettings& settings = {}) {
    return Replanner(known_, model_, environment_, ErrorRoom{}, settings, 1);
  }

  const ArmDescription arm_ = small_arm();
  const ArmDescription known_;
  const ForwardModel forward_{known_, play_network(known_, 0.0F)};
  const MotionModel model_{forward_};
  Environment environment_;
};

/// Its network says what the no-load model says, and remembers nothing of where the arm was.
class NearlyKnownArm : public ReplannerTest {
 protected:
  NearlyKnownArm() : ReplannerTest(0.7) {}
};

TEST_F(NearlyKnownArm, IsCorrectedFromWhereTheOpenLoopEnded) {
  FakeArm blind(arm_, kInstant_s);
  const ExecutionResult open_loop = run(blind, std::nullopt);
  ASSERT_GT(open_loop.goal_error.position_m, 0.005);
  EXPECT_EQ(open_loop.replans, 0);

  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = run(driver, ReplannerSettings{});
  EXPECT_TRUE(result.goal_reached);
  EXPECT_GT(result.replans, 0);
  ASSERT_TRUE(result.open_loop_goal_error.has_value());
  EXPECT_DOUBLE_EQ(result.open_loop_goal_error->position_m, open_loop.goal_error.position_m);
}

TEST_F(ReplannerTest, NoSetPointIsBeyondTheLimitsOrTheRate) {
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult result = run(driver, ReplannerSettings{});
  const auto& setpoints = result.episode.setpoint_kpa;
  ASSERT_GT(setpoints.rows(), 10);
  EXPECT_LE(setpoints.cwiseAbs().maxCoeff(), 100.0F);
  const Eigen::Index last = setpoints.rows() - 1;
  EXPECT_LE((setpoints.bottomRows(last) - setpoints.topRows(last)).cwiseAbs().maxCoeff(),
            float(known_.pressure_step_limit_kpa()) + 1e-3F);
}

TEST_F(ReplannerTest, PlansWithinTheLimitsInForceAndThoseOfThePlan) {
  Plan plan = open_loop_plan();
  const Pressures end_kpa = plan.frames.back().setpoint_kpa;
  const double lower_kpa = std::min(0.0, double(end_kpa.minCoeff())) - 5.0;
  const double upper_kpa = std::max(0.0, double(end_kpa.maxCoeff())) + 5.0;
  plan.limits.assign(2, PressureLimits(lower_kpa, 100.0));
  ReplannerSettings settings;
  settings.limits.assign(2, PressureLimits(-100.0, upper_kpa));
  FakeArm driver(arm_, kInstant_s);
  driver.command(end_kpa);
  const ArmState state = driver.state();  // beside the goal, as the model is not the arm's
  Replanner source = replanner(settings);
  const std::optional<Plan> next =
      source.next(plan, plan.frames.size() - 1, end_kpa, state.backbone, {});
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->limits[0], PressureLimits(lower_kpa, upper_kpa));
  for (const PlanFrame& frame : next->frames) {
    EXPECT_GE(double(frame.setpoint_kpa.minCoeff()), lower_kpa);
    EXPECT_LE(double(frame.setpoint_kpa.maxCoeff()), upper_kpa);
  }
}

TEST_F(ReplannerTest, AsksForNothingWhereNobodySeesTheArm) {
  FakeFaults faults;
  faults.drop_every = 1;
  FakeArm driver(arm_, kInstant_s, faults);
  const ExecutionResult result = run(driver, ReplannerSettings{});
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_EQ(result.replans, 0);
}

TEST_F(ReplannerTest, EndsAfterAsManyPlansAsAllowed) {
  ReplannerSettings settings;
  settings.max_replans = 1;
  FakeArm driver(arm_, kInstant_s);
  EXPECT_EQ(run(driver, settings).replans, 1);
}

TEST_F(ReplannerTest, SameSeedSameRun) {
  std::vector<double> ends;
  for (int k = 0; k < 2; ++k) {
    FakeArm driver(arm_, kInstant_s);
    ends.push_back(run(driver, ReplannerSettings{}).goal_error.position_m);
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST_F(ReplannerTest, HaltsWhereTheArmStraysTowardsAnObstacle) {
  Plan plan = open_loop_plan();
  plan.clearance_m = 0.02;
  std::optional<Backbone> seen = plan.frames[1].backbone;
  const Pose tip = tip_pose(*seen);
  Replanner alone = replanner();
  const double reach_m = known_.segments.back().width_m / 2.0 + known_.actuator_radius_m;
  environment_.obstacles = {Circle{tip.x_m, tip.y_m + 0.021 + reach_m + 0.005 + 0.02, 0.02}};
  Replanner source = replanner();
  EXPECT_TRUE(source.may_go_on(plan, 1, seen));
  seen->col(1).array() += 0.019F;
  EXPECT_TRUE(source.may_go_on(plan, 1, seen));
  seen->col(1).array() += 0.002F;
  EXPECT_FALSE(source.may_go_on(plan, 1, seen));
  EXPECT_TRUE(alone.may_go_on(plan, 1, seen)) << "nothing is near";
  seen.reset();
  EXPECT_TRUE(source.may_go_on(plan, 1, seen)) << "nobody sees it";
}

TEST_F(ReplannerTest, AHaltedArmThatFoundNoWaySearchesOnceMoreWithMoreQueries) {
  const Plan plan = open_loop_plan();
  const PlanFrame& halt = plan.frames[1];
  environment_.obstacles = {
      Circle{0.35, -0.08, 0.002}};  // beside the straight way, which it blocks
  ReplannerSettings settings;
  settings.queries = 400;
  constexpr std::uint64_t kSeeds = 20;
  std::uint64_t found_at_once = 0;
  std::uint64_t found_later = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Replanner source(known_, model_, environment_, ErrorRoom{}, settings, seed);
    const auto ask = [&] {
      return source.next(plan, 1, halt.setpoint_kpa, halt.backbone, {}).has_value();
    };
    if (ask()) {
      ++found_at_once;
    } else if (ask()) {
      ++found_later;
    }
  }
  EXPECT_EQ(found_at_once + found_later, kSeeds);
  EXPECT_GT(found_later, found_at_once);
}

}  // namespace
}  // namespace limber
