#include "limber/world/obstacle_shape.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

/// Corners at random distances all around.
ObstacleShape ragged_shape(int corners, RandomStream& random) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double radius_m = random.uniform(0.05, 0.15);
    polygon.points_m.emplace_back(radius_m * std::cos(angle), radius_m * std::sin(angle));
  }
  return make_obstacle_shape(polygon, 0);
}

// Boxes around the edges leave out work, and nothing else: with boxes that leave out nothing, every
// distance is the same to the bit.
TEST(ObstacleShape, BoxesChangeNoDistance) {
  constexpr double kEverywhere_m = 1e6;
  RandomStream random(3, 0);
  int inside = 0;
  for (const int corners : {3, 15, 16, 17, 33, 200}) {
    const ObstacleShape shape = ragged_shape(corners, random);
    ASSERT_EQ(shape.edge_boxes.size(), std::size_t(corners + 15) / 16);
    ObstacleShape plain = shape;
    for (Box& box : plain.edge_boxes) {
      box = {Eigen::Vector2d::Constant(-kEverywhere_m), Eigen::Vector2d::Constant(kEverywhere_m)};
    }
    for (int i = 0; i < 5000; ++i) {
      const Eigen::Vector2d a(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      const Eigen::Vector2d b(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3));
      ASSERT_EQ(signed_distance(shape, a), signed_distance(plain, a)) << corners;
      ASSERT_EQ(outside_distance(shape, a, b), outside_distance(plain, a, b)) << corners;
      ASSERT_EQ(signed_distance(shape, a, b), signed_distance(plain, a, b)) << corners;
      inside += signed_distance(shape, a) < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 500);
}

}  // namespace
}  // namespace limber
