#include "limber/planning/plan_builder.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/version.hpp"
#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

class PlanBuilder : public ::testing::Test {
 protected:
  Plan build(const std::vector<Pressures>& waypoints_kpa,
             const std::function<bool()>& give_up = {}) {
    return build_plan(problem_, simulator_, waypoints_kpa, "test", 7, give_up);
  }

  Setting setting_{true};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  MotionSimulator simulator_{setting_.arm, setting_.model, checker_};
  std::vector<Pressures> bent_kpa_{Pressures::Zero(3), Eigen::Vector3f(-20.0F, 10.0F, 0.0F),
                                   Eigen::Vector3f(-15.0F, -5.0F, 8.0F)};
};

TEST_F(PlanBuilder, FramesAreThoseOfTheMotionsAndTheHoldBehindThem) {
  const Plan plan = build(bent_kpa_);
  EXPECT_NO_THROW(require_plan_of(plan, setting_.arm, "plan"));
  const Walk alone = walk(problem_, checker_, bent_kpa_);
  ASSERT_TRUE(alone.is_free);
  const Pose tip = tip_pose(plan.frames.back().backbone);
  EXPECT_EQ(tip.x_m, alone.held_tip.x_m);
  EXPECT_EQ(tip.y_m, alone.held_tip.y_m);
  const std::size_t moving = plan.frames.size() - std::size_t(plan.hold_frame_count);
  EXPECT_EQ(plan.frames[moving - 1].setpoint_kpa, bent_kpa_.back());
  EXPECT_EQ(plan.frames[moving - 1].backbone, alone.states.back().backbone);
  EXPECT_NEAR(plan.cost_kpa, path_cost_kpa(bent_kpa_), 1e-3);
  const PoseError error = pose_error(setting_.environment.goal, alone.held_tip);
  EXPECT_EQ(plan.goal_distance_m, error.position_m);
}

TEST_F(PlanBuilder, SaysWhoseItIs) {
  problem_.margin_m = 0.01;
  const Plan plan = build(bent_kpa_);
  EXPECT_EQ(plan.arm_hash, setting_.arm.hash());
  EXPECT_EQ(plan.model, "network");
  EXPECT_EQ(plan.environment_name, "pillars");
  EXPECT_EQ(plan.environment_hash, environment_hash(setting_.environment));
  EXPECT_EQ(plan.planner, "test");
  EXPECT_EQ(plan.seed, 7U);
  EXPECT_EQ(plan.margin_m, 0.01);
  EXPECT_EQ(plan.program_version, version());
}

// By sampling along arcs and between frames: below the true clearance by at most the checker's
// tolerance, never above.
TEST_F(PlanBuilder, ClearanceIsTheLeastOfAllFrames) {
  const Plan plan = build(bent_kpa_);
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    for (const float t : {0.0F, 0.5F, 1.0F}) {
      const Backbone between =
          (1.0F - t) * plan.frames[k - 1].backbone + t * plan.frames[k].backbone;
      least_m = std::min(
          least_m, oracle::clearance(setting_.arm, between, setting_.environment.obstacles, 24));
    }
  }
  constexpr double kSamplingM = 2e-4;
  EXPECT_LE(plan.clearance_m, least_m + 1e-6);
  EXPECT_GE(plan.clearance_m, least_m - CollisionChecker::kToleranceM - kSamplingM);
}

TEST_F(PlanBuilder, GivenUpItsClearanceIsThatOfTheFramesSoFar) {
  const double whole_m = build(bent_kpa_).clearance_m;
  const Plan first = build(bent_kpa_, [] { return true; });
  EXPECT_EQ(first.clearance_m, checker_.clearance(first.frames.front().backbone).value_m);
  EXPECT_GT(first.clearance_m, whole_m);
  EXPECT_EQ(first.frames.size(), build(bent_kpa_).frames.size());
}

TEST_F(PlanBuilder, ASolutionIsFreeAllTheWayAndEndsInTheGoal) {
  Plan plan = build(bent_kpa_);
  EXPECT_THAT(why_no_solution(problem_, checker_, plan), HasSubstr("outside of the goal"));
  const Pose tip = tip_pose(plan.frames.back().backbone);
  setting_.environment.goal = {tip.x_m, tip.y_m, std::nullopt, 0.01, 0.3};
  plan = build(bent_kpa_);
  EXPECT_EQ(why_no_solution(problem_, checker_, plan), "");
  // An obstacle on the way alone, which neither the start nor the end touches.
  const Backbone& between = plan.frames[plan.frames.size() / 4].backbone;
  setting_.environment.obstacles = {
      Circle{double(between(15, 0)), double(between(15, 1)) + 0.012, 0.001}};
  const CollisionChecker blocked(setting_.arm, setting_.environment.obstacles);
  EXPECT_THAT(why_no_solution(problem_, blocked, plan),
              HasSubstr("short of the clearance from obstacle 0"));
}

// There may be no obstacle that such a shape could be too near to.
TEST_F(PlanBuilder, AShapeThatNoArmHasIsNamedWithObstaclesAndWithout) {
  Plan plan = build(bent_kpa_);
  plan.frames[1].backbone(3, 0) = std::numeric_limits<float>::infinity();
  for (const bool is_empty : {false, true}) {
    if (is_empty) {
      setting_.environment.obstacles.clear();
    }
    EXPECT_EQ(why_no_solution(problem_, checker_of(problem_), plan),
              "the model predicts a shape that no arm has in frame 1");
  }
}

}  // namespace
}  // namespace limber
