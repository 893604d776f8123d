#include "limber/run/appearing_obstacle.hpp"

#include <gtest/gtest.h>

#include "limber/run/executor.hpp"
#include "limber/world/collision.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr double kRadius_m = 0.02;
/// Slow enough for a motion of 4 s.
ArmDescription slow_arm() {
  ArmDescription arm = small_arm();
  arm.pressure_rate_limit_kpa_per_s = 40.0;
  return arm;
}

class AppearingObstacleTest : public ::testing::Test {
 protected:
  std::optional<AppearingObstacle> sampled(std::uint64_t seed) const {
    return appearing_obstacle(arm_, plan_, kRadius_m, seed, 0);
  }

  const ArmDescription arm_ = slow_arm();
  const Environment environment_{};
  const Plan plan_ = bending_plan(arm_, environment_);
};

TEST_F(AppearingObstacleTest, IsAheadOnTheRestOfThePlanByASecondAndFiveCentimetres) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::optional<AppearingObstacle> obstacle = sampled(seed);
    if (!obstacle) {
      continue;
    }
    ++found;
    ASSERT_FALSE(obstacle->circles.empty());
    for (const Circle& circle : obstacle->circles) {
      const CollisionChecker checker(arm_, {circle});
      const auto frame = static_cast<std::size_t>(obstacle->frame);
      EXPECT_GE(checker.clearance(plan_.frames[frame].backbone).value_m, 0.05);
      int first_touch = -1;
      for (int k = obstacle->frame; k < plan_.frame_count() && first_touch < 0; ++k) {
        if (!checker.is_free(plan_.frames[static_cast<std::size_t>(k)].backbone)) {
          first_touch = k;
        }
      }
      ASSERT_GE(first_touch, 0) << "it is not on the path";
      EXPECT_GE(first_touch - obstacle->frame, arm_.frames_in(1.0));
    }
  }
  EXPECT_GT(found, 25);
}

TEST_F(AppearingObstacleTest, SeedsRepeat) {
  const auto a = sampled(3);
  const auto b = sampled(3);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->frame, b->frame);
  EXPECT_EQ(a->circles.front().x_m, b->circles.front().x_m);
}

TEST_F(AppearingObstacleTest, AShortMotionHasNone) {
  const Plan fast = bending_plan(small_arm(), environment_);  // 16 frames
  EXPECT_FALSE(appearing_obstacle(small_arm(), fast, kRadius_m, 1, 0));
}

TEST_F(AppearingObstacleTest, ThePlaceKeepsFiveCentimetresFromTheArmAsItReallyIs) {
  const AppearingObstacle obstacle{1, {Circle{0.3, 0.0, kRadius_m}, Circle{0.3, 0.3, kRadius_m}}};
  const BackboneD straight = plan_.frames.front().backbone.cast<double>();
  const std::optional<Circle> circle = circle_ahead_of(arm_, obstacle, straight);
  ASSERT_TRUE(circle);
  EXPECT_EQ(circle->y_m, 0.3) << "the first lies on the arm";
  EXPECT_FALSE(circle_ahead_of(arm_, {1, {Circle{0.3, 0.08, kRadius_m}}}, straight));
}

TEST_F(AppearingObstacleTest, WhoRunsIntoItOpenLoopCollidesWithItAfterItAppeared) {
  const std::optional<AppearingObstacle> obstacle = sampled(3);
  ASSERT_TRUE(obstacle);
  ExecutionSettings settings;
  settings.obstacle = &*obstacle;
  FakeArm driver(arm_, kInstant_s);
  const ExecutionResult run = execute(arm_, environment_, plan_, driver, settings);
  ASSERT_TRUE(run.appeared);
  EXPECT_DOUBLE_EQ(run.appeared->time_s, obstacle->frame * arm_.frame_period_s());
  ASSERT_TRUE(run.first_collision);
  EXPECT_GE(run.first_collision->time_s, run.appeared->time_s + 1.0 - 1e-9);
  EXPECT_EQ(run.first_collision->clearance.obstacle, 0) << "after those of the environment";
  EXPECT_EQ(with_appeared(environment_, run).obstacles.size(), 1U);
  EXPECT_FALSE(run.stopped_ahead);

  FakeArm again(arm_, kInstant_s);
  const ExecutionResult free = execute(arm_, environment_, plan_, again);
  EXPECT_FALSE(free.appeared || free.collided);
  EXPECT_EQ(free.episode.setpoint_kpa, run.episode.setpoint_kpa);
}

}  // namespace
}  // namespace limber
