// Runs in which a network's plan is followed by its shapes (ShapeFeedback).
#include <gtest/gtest.h>

#include "limber/planning/planner_factory.hpp"
#include "limber/run/closed_loop.hpp"
#include "planning/play_model.hpp"
#include "support/bending_arms.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr float kNoPlayM = 0.0F;  // the network then says what the no-load model says

/// A network without play, of an arm that bends less than it says.
class LedRunTest : public ::testing::Test {
 protected:
  LedRunTest() {
    environment_.name = "a goal to the right";
    environment_.goal = goal_at(known_, Pressures::Constant(2, 50.0F));
    PlannerLimits limits;
    limits.queries = 5000;
    PlanResult result =
        make_planner("default", 1)->plan({known_, model_, environment_, 0.0}, limits, 1);
    EXPECT_TRUE(result.plan.has_value()) << result.reason;
    plan_ = result.plan.value_or(Plan{});
    // It ends at the goal's centre, and not at the rim.
    const Pose end = tip_pose(plan_.frames.back().backbone);
    environment_.goal = {end.x_m, end.y_m, std::nullopt, 0.02, 0.1};
    plan_.environment_hash = environment_hash(environment_);
    plan_.goal_distance_m = 0.0;
  }

  ExecutionResult run(ArmDriver& driver, std::uint64_t motion_queries) const {
    ClosedLoopSettings loop_settings;
    loop_settings.corrections.max_replans = 0;  // what comes after the plan does not count
    loop_settings.motion_queries = motion_queries;
    ClosedLoop loop(known_, model_, environment_, ErrorRoom{}, loop_settings, 1);
    ExecutionSettings settings;
    settings.controller = &loop;
    return execute(known_, environment_, plan_, driver, settings);
  }

  const ArmDescription known_ = slow(small_arm());
  const ArmDescription weak_ = bending(known_, 0.7);
  const ForwardModel forward_{known_, play_network(known_, kNoPlayM)};
  const MotionModel model_{forward_};
  Environment environment_;
  Plan plan_;
};

TEST_F(LedRunTest, AWeakArmIsLedIntoTheGoal) {
  FakeArm one(weak_, kInstant_s);
  const ExecutionResult alone = run(one, 0);
  ASSERT_GT(alone.goal_error.position_m, environment_.goal.position_tolerance_m)
      << "without queries in motion it has the plan's set points";
  EXPECT_EQ(alone.episode.setpoint_kpa.row(3), plan_.frames[3].setpoint_kpa.transpose());
  FakeArm other(weak_, kInstant_s);
  const ExecutionResult led = run(other, 1000);
  EXPECT_LT(led.goal_error.position_m, 0.5 * environment_.goal.position_tolerance_m);
  EXPECT_TRUE(led.goal_reached);
}

TEST_F(LedRunTest, AnArmAsTheNetworkKnowsItHasThePlansSetPoints) {
  FakeArm driver(known_, kInstant_s);
  const ExecutionResult led = run(driver, 1000);
  constexpr float kRoundingKpa = 0.05F;
  for (std::size_t k = 1; k < plan_.frames.size(); ++k) {
    const Pressures sent = led.episode.setpoint_kpa.row(static_cast<Eigen::Index>(k));
    EXPECT_LT((sent - plan_.frames[k].setpoint_kpa).cwiseAbs().maxCoeff(), kRoundingKpa) << k;
  }
}

TEST_F(LedRunTest, KeepsTheLimitsAndTheFrameRule) {
  const ArmDescription very_weak = bending(known_, 0.3);
  FakeArm driver(very_weak, kInstant_s);
  const auto setpoints = run(driver, 1000).episode.setpoint_kpa;
  const Eigen::Index last = setpoints.rows() - 1;
  ASSERT_GT(last, 10);
  EXPECT_LE(setpoints.cwiseAbs().maxCoeff(), 100.0F);
  EXPECT_LE((setpoints.bottomRows(last) - setpoints.topRows(last)).cwiseAbs().maxCoeff(),
            float(known_.pressure_step_limit_kpa()) + 1e-3F);
}

TEST_F(LedRunTest, AnArmThatNobodySeesHasThePlansSetPoints) {
  FakeFaults blind;
  blind.drop_every = 1;
  FakeArm driver(weak_, kInstant_s, blind);
  const ExecutionResult result = run(driver, 1000);
  EXPECT_EQ(driver.state().backbone, std::nullopt);
  EXPECT_EQ(result.switches + result.replans + result.halts, 0);
}

}  // namespace
}  // namespace limber
