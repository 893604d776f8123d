#include "limber/world/straight_motion.hpp"

#include <gtest/gtest.h>

#include "limber/world/plan.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

TEST(FrameRule, NoSegmentMovesFasterThanTheLimitAndNoFrameIsWasted) {
  const ArmDescription arm = three_segment_arm();
  const double limit = arm.pressure_step_limit_kpa();
  RandomStream random(6, 0);
  for (int trial = 0; trial < 500; ++trial) {
    const Pressures from = random_pressures(arm, random);
    const Pressures to = random_pressures(arm, random);
    const int count = motion_frame_count(from, to, limit);
    EXPECT_EQ(motion_frame_count(to, from, limit), count);
    Pressures before = from;
    Pressures now(3);
    for (int k = 1; k <= count; ++k) {
      motion_setpoint(from, to, k, count, now);
      EXPECT_LE((now - before).lpNorm<Eigen::Infinity>(), limit + 1e-4);
      EXPECT_LE(now.lpNorm<Eigen::Infinity>(), 100.0F);
      before = now;
    }
    EXPECT_EQ(now, to);
    EXPECT_GT((to - from).lpNorm<Eigen::Infinity>() / (count - 1 + 1e-9), limit);
  }
}

TEST(FrameRule, WholeFramesAreNotRoundedUp) {
  EXPECT_EQ(motion_frame_count(Pressures::Zero(3), Pressures::Constant(3, 50.0F), 5.0), 10);
  EXPECT_EQ(motion_frame_count(Pressures::Constant(3, 0.1F), Pressures::Constant(3, 5.1F), 5.0), 1);
  EXPECT_EQ(motion_frame_count(Pressures::Zero(3), Pressures::Constant(3, 5.1F), 5.0), 2);
  EXPECT_EQ(motion_frame_count(Pressures::Zero(3), Pressures::Zero(3), 5.0), 1);
}

TEST(MotionSetpoint, RunsEvenlyAlongTheLine) {
  const Pressures from = Pressures::Constant(2, -20.0F);
  const Pressures to = Eigen::Vector2f(35.0F, 0.0F);
  const int count = motion_frame_count(from, to, 10.0);
  ASSERT_EQ(count, 6);  // 55 kPa in steps of at most 10
  Pressures before = from;
  Pressures now(2);
  for (int k = 1; k <= count; ++k) {
    motion_setpoint(from, to, k, count, now);
    EXPECT_TRUE((now - before).isApprox((to - from) / 6.0F, 1e-5F));
    before = now;
  }
  EXPECT_EQ(now, to);
}

TEST(PathCost, IsTheSumOfAllPressureChanges) {
  const std::vector<Pressures> path{Eigen::Vector2f(0.0F, 0.0F), Eigen::Vector2f(3.0F, -1.0F),
                                    Eigen::Vector2f(1.0F, -4.0F), Eigen::Vector2f(1.0F, -4.0F)};
  EXPECT_DOUBLE_EQ(path_cost_kpa(path), 4.0 + 5.0);
  EXPECT_DOUBLE_EQ(motion_cost_kpa(path[0], path[1]) + motion_cost_kpa(path[1], path[2]), 9.0);
  std::vector<PlanFrame> frames;
  for (const Pressures& setpoint_kpa : path) {
    frames.push_back({setpoint_kpa, Pressures::Zero(2), Backbone()});
  }
  EXPECT_EQ(path_cost_kpa(frames, &PlanFrame::setpoint_kpa), path_cost_kpa(path));
}

// What stands still, and what never moved, costs nothing.
TEST(PathCost, OfOnePointIsZero) {
  EXPECT_EQ(path_cost_kpa(std::vector<Pressures>()), 0.0);
  EXPECT_EQ(path_cost_kpa(std::vector<Pressures>{Pressures::Constant(3, 50.0F)}), 0.0);
}

}  // namespace
}  // namespace limber
