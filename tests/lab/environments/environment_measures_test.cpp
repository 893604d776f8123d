#include "limber/lab/environment_measures.hpp"

#include <gtest/gtest.h>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

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
