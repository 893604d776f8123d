#include "limber/lab/environment_measures.hpp"

#include <gtest/gtest.h>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

constexpr double kFloatM = 1e-6;

Plan at_rest(const ArmDescription& arm) {
  const ArmStart rest = start_state(Environment{}, arm);
  Plan plan;
  plan.frames = {{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
  return plan;
}

TEST(NarrowestPassage, IsTheWayAcrossTheArmFromObstacleToObstacle) {
  const ArmDescription arm = three_segment_arm();
  Environment e;
  e.obstacles = {Rectangle{0.6, 0.09, 0.1, 0.1, 0.0}, Rectangle{0.6, -0.11, 0.1, 0.1, 0.0},
                 Rectangle{0.1, 0.2, 0.1, 0.1, 0.0}};
  const auto passage = narrowest_passage(arm, e, at_rest(arm).frames);
  ASSERT_TRUE(passage);
  EXPECT_NEAR(passage->width_m, 0.1, kFloatM);
  EXPECT_NEAR(passage->arm_width_m, 0.0172 + 0.012, kFloatM);
  EXPECT_EQ(passage->plate, 12);
  EXPECT_EQ(passage->frame, 0);
}

TEST(NarrowestPassage, IsMetBesideCirclesAndPolygonsToo) {
  const ArmDescription arm = three_segment_arm();
  Environment e;
  const double x = 3 * 0.235 / 5;  // of plate 3
  e.obstacles = {Circle{x, 0.2, 0.05},
                 Polygon{{{x - 0.1, -0.1}, {x, -0.07}, {x + 0.1, -0.1}, {x, -0.3}}}};
  const auto passage = narrowest_passage(arm, e, at_rest(arm).frames);
  ASSERT_TRUE(passage);
  EXPECT_NEAR(passage->width_m, 0.15 + 0.07, kFloatM);
  EXPECT_NEAR(passage->arm_width_m, 0.062, kFloatM);
}

TEST(NarrowestPassage, NeedsObstaclesOnBothSides) {
  const ArmDescription arm = three_segment_arm();
  Environment e;
  e.obstacles = {Rectangle{0.6, 0.09, 0.1, 0.1, 0.0}};
  EXPECT_FALSE(narrowest_passage(arm, e, at_rest(arm).frames));
}

TEST(Reversal, IsTheCostBeyondTheStraightMotions) {
  std::vector<PlanFrame> frames(3);
  frames[0].setpoint_kpa = Eigen::Vector2f(0.0F, 0.0F);
  frames[1].setpoint_kpa = Eigen::Vector2f(4.0F, 2.0F);
  frames[2].setpoint_kpa = Eigen::Vector2f(1.0F, 5.0F);
  EXPECT_DOUBLE_EQ(reversal_kpa(frames), 6.0);
  frames[2].setpoint_kpa[0] = 9.0F;
  EXPECT_DOUBLE_EQ(reversal_kpa(frames), 0.0);
}

TEST(StraightLine, CollidesAndSolvesAsTheObstaclesLetIt) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm);
  Environment e;
  Pressures q(3);
  q << -30.0F, -60.0F, -80.0F;
  const Backbone end = no_load_backbone(model.no_load(), q);
  e.goal = {end(15, 0), end(15, 1), std::nullopt, 0.02, 0.3};
  EXPECT_FALSE(straight_line_collides({arm, model, e}, q));
  EXPECT_TRUE(straight_line_solves({arm, model, e}, {}, 20, 1));
  // A wall across the way of the tip, from far out to near the base.
  const Backbone halfway = no_load_backbone(model.no_load(), q * 0.5F);
  e.obstacles = {Circle{halfway(15, 0), halfway(15, 1), 0.02}};
  EXPECT_TRUE(straight_line_collides({arm, model, e}, q));
  EXPECT_FALSE(straight_line_collides({arm, model, e}, q * 0.1F));
  EXPECT_FALSE(straight_line_solves({arm, model, e}, {q, q * 0.1F}, 1, 1))
      << "one collides, one ends elsewhere";
}

}  // namespace
}  // namespace limber
