#include "limber/arm/plate_distance.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/backbone.hpp"

namespace limber {
namespace {

constexpr double kFloatRounding = 1e-7;  // relative, of a float distance

TEST(PlateDistance, IsPythagorassPlateByPlateAndKnowsNoHeadings) {
  Backbone a(3, kPoseSize);
  a << 0.0F, 0.0F, 1.0F, 0.1F, 0.0F, 2.0F, 0.2F, 0.1F, 3.0F;
  Backbone b = a;
  b.col(2).setZero();
  EXPECT_EQ(largest_plate_distance_m(a, b), 0.0);
  b.row(1).head<2>() += Eigen::RowVector2f(3.0F, -4.0F);
  b.row(2).head<2>() += Eigen::RowVector2f(0.0F, 1.0F);
  const Eigen::VectorXd apart_m = plate_distances_m(a, b);
  EXPECT_EQ(apart_m.size(), 3);
  EXPECT_EQ(apart_m[0], 0.0);
  EXPECT_NEAR(apart_m[1], 5.0, 5.0 * kFloatRounding);
  EXPECT_NEAR(apart_m[2], 1.0, 5.0 * kFloatRounding);
  EXPECT_EQ(largest_plate_distance_m(a, b), apart_m[1]);
}

TEST(PlateDistance, IsSymmetricAndObeysTheTriangleInequality) {
  const BackboneD a = BackboneD::Random(16, kPoseSize);
  const BackboneD b = BackboneD::Random(16, kPoseSize);
  const BackboneD c = BackboneD::Random(16, kPoseSize);
  EXPECT_EQ(largest_plate_distance_m(a, b), largest_plate_distance_m(b, a));
  EXPECT_LE(largest_plate_distance_m(a, c),
            largest_plate_distance_m(a, b) + largest_plate_distance_m(b, c));
}

TEST(PlateDistance, OfFloatsIsTakenInDouble) {
  const Backbone a = Backbone::Random(5, kPoseSize);
  const Backbone b = Backbone::Random(5, kPoseSize);
  const auto row = (a - b).row(3).eval();
  EXPECT_EQ(plate_distances_m(a, b)[3],
            std::sqrt(double(row[0]) * double(row[0]) + double(row[1]) * double(row[1])));
}

}  // namespace
}  // namespace limber
