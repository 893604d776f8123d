#include "src/run/closed_loop/plan_repair.hpp"

#include <gtest/gtest.h>

#include "limber/world/environment.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

struct RepairSetting {
  ArmDescription arm = small_arm(3);
  ForwardModel forward{arm};
  MotionModel model{forward};
  Environment environment;
  std::vector<PressureLimits> limits;
  std::vector<Pressures> waypoints_kpa{Pressures::Zero(3), Pressures::Constant(3, 30.0F),
                                       Pressures::Constant(3, 60.0F)};

  Pose end(const std::vector<Pressures>& along) {
    const CollisionChecker free(arm, {});
    MotionSimulator simulator(arm, model, free);
    MotionState state = simulator.start(start_state(Environment{}, arm));
    for (std::size_t w = 1; w < along.size(); ++w) {
      simulator.move_unchecked(state, along[w], state);
    }
    return tip_pose(state.backbone);
  }

  std::optional<std::vector<Pressures>> repaired(const PoseGoal& goal, double max_error_m) {
    environment.goal = goal;
    PlanningProblem problem{arm, model, environment};
    problem.limits = limits;
    const PlanCheck accept = [](Plan&, const Environment&) { return true; };
    const std::optional<Plan> plan = repaired_plan(problem, waypoints_kpa, max_error_m, 0, accept);
    return plan ? std::optional(plan->waypoints_kpa) : std::nullopt;
  }
};

TEST(PlanRepair, EndsWhereItIsAskedTo) {
  RepairSetting s;
  for (const float share : {-1.0F, 0.3F, 1.0F}) {
    std::vector<Pressures> there = s.waypoints_kpa;
    there.back() += share * Eigen::Vector3f(15.0F, -10.0F, 20.0F);
    const Pose tip = s.end(there);
    const PoseGoal goal{tip.x_m, tip.y_m, std::nullopt, 0.02, 0.1};
    const auto repaired = s.repaired(goal, 0.005);
    ASSERT_TRUE(repaired) << share;
    EXPECT_LT(pose_error(goal, s.end(*repaired)).position_m, 0.001) << share;
    EXPECT_EQ(repaired->front(), s.waypoints_kpa.front()) << "it is there already";
    EXPECT_EQ(repaired->size(), s.waypoints_kpa.size());
  }
}

TEST(PlanRepair, TurnsTheTipWhereAHeadingIsAskedFor) {
  RepairSetting s;
  const Pose now = s.end(s.waypoints_kpa);
  const PoseGoal goal{now.x_m, now.y_m, now.theta_rad + 0.1, 0.02, 0.1};
  const auto repaired = s.repaired(goal, 0.01);
  ASSERT_TRUE(repaired);
  EXPECT_LT(as_length_m(goal, pose_error(goal, s.end(*repaired))), 0.005);
}

TEST(PlanRepair, KeepsTheLimitsAndReturnsNothingThatIsNotNearEnough) {
  RepairSetting s;
  const Pose now = s.end(s.waypoints_kpa);
  s.limits.assign(3, PressureLimits(-61.0, 61.0));
  const PoseGoal goal{now.x_m, now.y_m - 0.2, std::nullopt, 0.02, 0.1};
  EXPECT_FALSE(s.repaired(goal, 0.01));
  const auto nearer = s.repaired(goal, 1.0);
  ASSERT_TRUE(nearer);
  for (const Pressures& kpa : *nearer) {
    EXPECT_LE(kpa.cwiseAbs().maxCoeff(), 61.0F);
  }
}

TEST(PlanRepair, ASegmentThatTheDriverAllowsNothingStaysAtZeroAndTheOthersRepair) {
  RepairSetting s;
  s.limits = {PressureLimits(61.0), PressureLimits(0.0), PressureLimits(61.0)};
  for (Pressures& kpa : s.waypoints_kpa) {
    kpa[1] = 0.0F;
  }
  std::vector<Pressures> there = s.waypoints_kpa;
  there.back() -= Eigen::Vector3f(15.0F, 0.0F, 10.0F);
  const Pose tip = s.end(there);
  const PoseGoal goal{tip.x_m, tip.y_m, std::nullopt, 0.02, 0.1};
  const auto repaired = s.repaired(goal, 0.005);
  ASSERT_TRUE(repaired);
  EXPECT_LT(pose_error(goal, s.end(*repaired)).position_m, 0.001);
  for (const Pressures& kpa : *repaired) {
    EXPECT_EQ(kpa[1], 0.0F);
  }
}

TEST(PlanRepair, NothingThatTouchesAnObstacleIsARepair) {
  RepairSetting s;
  const Pose now = s.end(s.waypoints_kpa);
  s.environment.obstacles = {Circle{now.x_m, now.y_m, 0.01}};
  EXPECT_FALSE(s.repaired({now.x_m, now.y_m, std::nullopt, 0.02, 0.1}, 1.0));
}

TEST(WaypointsAfter, AreThoseStillAheadAndTheFirstIsWhereTheArmIs) {
  const ArmDescription arm = small_arm();
  const Plan plan = bending_plan(arm, Environment{});  // 8 frames to the first waypoint, 8 more
  const auto rest = [&](std::size_t next) {
    return waypoints_after({plan, next, plan.frames[next].setpoint_kpa},
                           arm.pressure_step_limit_kpa());
  };
  EXPECT_EQ(rest(0), plan.waypoints_kpa);
  ASSERT_EQ(rest(3).size(), 3U);
  EXPECT_EQ(rest(3)[0], plan.frames[3].setpoint_kpa);
  EXPECT_EQ(rest(3)[1], plan.waypoints_kpa[1]);
  ASSERT_EQ(rest(8).size(), 2U);
  EXPECT_EQ(rest(8)[1], plan.waypoints_kpa[2]);
  EXPECT_EQ(rest(16), (std::vector<Pressures>{plan.waypoints_kpa[2], plan.waypoints_kpa[2]}));
}

}  // namespace
}  // namespace limber
