#include "limber/run/rest_average.hpp"

#include <gtest/gtest.h>

namespace limber {
namespace {

Backbone at(float x_m) {
  Backbone backbone = Backbone::Zero(3, 3);
  backbone.col(0).setConstant(x_m);
  return backbone;
}

TEST(RestAverage, IsTheMeanOfAnArmThatRests) {
  RestAverage rest(4);
  for (const float x_m : {9.0F, 0.0F, 0.001F, 0.001F, 0.0F}) {
    EXPECT_FALSE(rest.backbone());
    rest.observe(at(x_m));
  }
  ASSERT_TRUE(rest.backbone());
  EXPECT_NEAR(double((*rest.backbone())(1, 0)), 0.0005, 1e-7);
}

TEST(RestAverage, AnArmThatMovesHasNone) {
  RestAverage rest(4);
  for (const float x_m : {0.0F, 0.001F, 0.002F, 0.003F}) {
    rest.observe(at(x_m));
  }
  EXPECT_FALSE(rest.backbone());
}

TEST(RestAverage, TakesNoFramesFromBeforeOneThatWasNotTracked) {
  RestAverage rest(2);
  rest.observe(at(0.0F));
  rest.observe(std::nullopt);
  rest.observe(at(0.0F));
  EXPECT_FALSE(rest.backbone());
  rest.observe(at(0.0F));
  EXPECT_TRUE(rest.backbone());
}

// kRestS of an arm at 2 Hz.
TEST(RestAverage, OneFrameIsNoRest) {
  for (const float second_m : {1.0F, 1.01F}) {
    RestAverage rest(1);
    rest.observe(at(1.0F));
    EXPECT_FALSE(rest.backbone());
    rest.observe(at(second_m));
    EXPECT_EQ(rest.backbone().has_value(), second_m == 1.0F);
  }
}

}  // namespace
}  // namespace limber
