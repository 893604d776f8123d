#include "limber/network/quantized_shape.hpp"

#include <gtest/gtest.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using Shape = Eigen::Matrix<std::int16_t, Eigen::Dynamic, 1>;

struct Setting {
  ArmDescription arm = three_segment_arm();
  NoLoadModel model{arm};

  Backbone backbone(const Eigen::Vector3d& kpa) const {
    BackboneD exact(arm.point_count(), 3);
    model.backbone(kpa, exact);
    return exact.cast<float>();
  }
  Shape rounded(const Backbone& backbone) const {
    Shape shape(3 * (arm.point_count() - 1));
    round_shape(backbone, arm.length_m(), shape);
    return shape;
  }
  Backbone blended(const Shape& from, const Shape& to, float fraction) const {
    Backbone backbone = Backbone::Zero(arm.point_count(), 3);
    blend_shapes(from, to, fraction, arm.length_m(), backbone);
    return backbone;
  }
};

constexpr double kRoundingM = 5e-4;  // 15 gaps of half a unit each, and their turns' lever
constexpr double kUnevenM = 0.1;     // curvature is not quite proportional to pressure

double farthest_m(const Backbone& a, const Backbone& b) {
  return double((a - b).leftCols<2>().rowwise().norm().maxCoeff());
}

TEST(QuantizedShape, ComesBackWithinHalfAMillimetre) {
  const Setting s;
  RandomStream random(3, 1);
  for (int k = 0; k < 200; ++k) {
    const Backbone shape = s.backbone(
        {random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-100, 100)});
    const Shape stored = s.rounded(shape);
    EXPECT_LT(farthest_m(s.blended(stored, stored, 0.0F), shape), kRoundingM);
    EXPECT_EQ(s.blended(stored, s.rounded(s.backbone({0, 0, 0})), 0.0F),
              s.blended(stored, stored, 0.5F));
  }
}

// Without load curvature is nearly proportional to pressure, so halfway in pressure is halfway in
// every gap's turn; a tip that swings by half a turn is not halfway along its chord.
TEST(QuantizedShape, HalfwayBendsEveryGapByHalf) {
  const Setting s;
  const Backbone left = s.backbone({-80, -80, -80});
  const Backbone right = s.backbone({80, 80, 80});
  const Backbone straight = s.backbone({0, 0, 0});
  const Backbone halfway = s.blended(s.rounded(left), s.rounded(right), 0.5F);
  EXPECT_LT(farthest_m(halfway, straight), kUnevenM);
  EXPECT_GT(farthest_m(0.5F * (left + right), straight), 3.0 * kUnevenM);
  EXPECT_NEAR(halfway(15, 1), 0.0F, kRoundingM);
}

TEST(QuantizedShape, WhatDoesNotFitIsCutOff) {
  const Setting s;
  Backbone broken = Backbone::Zero(s.arm.point_count(), 3);
  broken(1, 0) = 1e6F;
  const Shape stored = s.rounded(broken);
  EXPECT_EQ(stored[0], 32767);
  EXPECT_EQ(stored[3], -32767);
}

}  // namespace
}  // namespace limber
