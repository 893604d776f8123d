// plan_along of planner_factory.hpp: motions that a caller proposes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<Pressures> without_start(const Plan& plan) {
  return {plan.waypoints_kpa.begin() + 1, plan.waypoints_kpa.end()};
}

TEST(PlanAlong, CertifiesTheMotionOfAPlanAndGivesItsFrames) {
  Setting s(true);
  const PlanResult found = s.plan("default", 3000);
  ASSERT_TRUE(found.plan) << found.reason;
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const PlanResult result = plan_along(problem, without_start(*found.plan), "mine", 7);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(result.certificate->certified());
  EXPECT_TRUE(result.plan->certified.has_value());
  EXPECT_EQ(result.plan->planner, "mine");
  EXPECT_EQ(result.plan->seed, 7U);
  EXPECT_EQ(result.plan->cost_kpa, found.plan->cost_kpa);
  ASSERT_EQ(result.plan->frame_count(), found.plan->frame_count());
  EXPECT_EQ(result.plan->frames.back().backbone, found.plan->frames.back().backbone);
  EXPECT_GT(result.statistics.queries, 0U);
  EXPECT_GE(result.first_solution->certificate_s, 0.0);
  expect_lawful(s, *result.plan);
}

TEST(PlanAlong, SaysHowFarFromTheGoalAMotionEnds) {
  Setting s(false);
  const Pressures stay = Pressures::Zero(3);
  const PlanResult result = plan_along({s.arm, s.model, s.environment}, {stay}, "mine");
  EXPECT_EQ(result.status, PlanStatus::not_certified);
  EXPECT_FALSE(result.plan);
  EXPECT_FALSE(result.certificate) << "a motion that misses the goal needs none";
  ASSERT_TRUE(result.best_partial);
  const Pose tip = tip_pose(result.best_partial->frames.back().backbone);
  const PoseGoal& goal = s.environment.goal;
  constexpr double kRoundingM = 1e-6;
  EXPECT_NEAR(result.best_partial->goal_distance_m,
              std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m), kRoundingM);
  EXPECT_THAT(result.reason, HasSubstr("from the goal's centre, outside of the goal"));
}

TEST(PlanAlong, NamesTheFrameAndTheObstacleOfACollision) {
  Setting s(false);
  const PlanResult around = s.plan("default", 1500);
  ASSERT_TRUE(around.plan);
  const Pressures end = around.plan->waypoints_kpa.back();  // straight there is the pillar
  const PlanResult result = plan_along({s.arm, s.model, s.environment}, {end}, "mine");
  EXPECT_EQ(result.status, PlanStatus::not_certified);
  EXPECT_THAT(result.reason, HasSubstr("the motion to frame "));
  EXPECT_THAT(result.reason, HasSubstr("circle"));
  ASSERT_TRUE(result.best_partial);
  EXPECT_FALSE(result.best_partial->certified);
}

TEST(PlanAlong, RefusesAProblemThatNoPlanSolves) {
  Setting s(false);
  s.environment.goal.x_m = 5.0;
  const PlanResult result =
      plan_along({s.arm, s.model, s.environment}, {Pressures::Zero(3)}, "mine");
  EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
  EXPECT_FALSE(result.best_partial);
}

// A loop whose arm has come nearer to an obstacle than its margin has to lead it away.
TEST(PlanAlong, TheMarginYieldsToAStartThatIsNearerWhereItMay) {
  Setting s(false);
  s.environment.obstacles = {Circle{0.2, -0.07, 0.02}};  // beside the arm as it starts
  PlanningProblem problem{s.arm, s.model, s.environment};
  problem.margin_m = 0.1;
  problem.margin_yields_to_start = true;
  PlannerLimits limits;
  limits.iterations = 5000;
  const PlanResult found = make_planner("default")->plan(problem, limits, 3);
  ASSERT_EQ(found.status, PlanStatus::solved) << found.reason;
  const std::vector<Pressures> waypoints = without_start(*found.plan);
  const PlanResult result = plan_along(problem, waypoints, "mine");
  EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_THAT(result.warnings.front(), HasSubstr("plans keep that distance instead"));
  problem.margin_yields_to_start = false;
  EXPECT_EQ(plan_along(problem, waypoints, "mine").status, PlanStatus::invalid_start);
}

TEST(PlanAlong, RefusesWaypointsThatAreNone) {
  Setting s(false);
  const PlanningProblem problem{s.arm, s.model, s.environment};
  EXPECT_THAT([&] { (void)plan_along(problem, {}, "mine"); },
              ThrowsMessage<InputError>(HasSubstr("no waypoints")));
  EXPECT_THAT([&] { (void)plan_along(problem, {Pressures::Zero(2)}, "mine"); },
              ThrowsMessage<InputError>(HasSubstr("waypoint 0 has 2 set points")));
  Pressures high = Pressures::Zero(3);
  for (const float bad : {1000.0F, std::numeric_limits<float>::quiet_NaN()}) {
    high[1] = bad;
    EXPECT_THAT(
        [&] {
          (void)plan_along(problem, {Pressures::Zero(3), high}, "mine");
        },
        ThrowsMessage<InputError>(HasSubstr("waypoint 1: segment 1 at ")));
  }
}

}  // namespace
}  // namespace limber
