#include "src/sim/spring_slider.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr SpringSlider kSlider{3000.0, 2.0, 0.05};
constexpr double kRounding = 1e-12;
constexpr double kStepS = 1e-6;  // fine enough that the work is an integral

TEST(SpringSlider, IsASpringBelowItsLimitAndLetsGoOfNothing) {
  double anchor = 0.2;
  EXPECT_NEAR(kSlider.force(0.2 + 1e-5, 0.0, anchor), -0.03, kRounding);
  EXPECT_EQ(anchor, 0.2);
  EXPECT_NEAR(kSlider.force(0.2, 0.0, anchor), 0.0, kRounding);
}

TEST(SpringSlider, DragsItsAnchorAtTheLimit) {
  double anchor = 0.0;
  EXPECT_NEAR(kSlider.force(0.1, 0.3, anchor), -kSlider.limit, kRounding);
  EXPECT_NEAR(anchor, 0.1 - kSlider.limit / kSlider.stiffness, kRounding);
  EXPECT_NEAR(kSlider.energy(0.1, anchor), 0.5 * kSlider.limit * kSlider.limit / kSlider.stiffness,
              kRounding);
}

TEST(SpringSlider, NeverExceedsItsLimitHoweverFast) {
  RandomStream random(1, 0);
  double anchor = 0.0;
  Eigen::Vector2d plane_anchor(0.0, 0.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d position(random.normal(), random.normal());
    const Eigen::Vector2d velocity(10.0 * random.normal(), 10.0 * random.normal());
    EXPECT_LE(std::abs(kSlider.force(position.x(), velocity.x(), anchor)), kSlider.limit);
    EXPECT_LE(kSlider.force(position, velocity, plane_anchor).norm(), kSlider.limit + kRounding);
  }
}

TEST(SpringSlider, IsNothingWithoutALimit) {
  const SpringSlider none{3000.0, 2.0, 0.0};
  Eigen::Vector2d anchor(0.0, 0.0);
  EXPECT_EQ(none.force(Eigen::Vector2d(0.1, 0.2), Eigen::Vector2d(1.0, 0.0), anchor).norm(), 0.0);
}

// The plane law turns with the plane, and along a line it is the law of the line.
TEST(SpringSlider, IsTheLineLawAlongEveryDirection) {
  const Eigen::Vector2d direction(std::cos(0.7), std::sin(0.7));
  double anchor = 0.0;
  Eigen::Vector2d plane_anchor(0.0, 0.0);
  for (int i = 0; i < 500; ++i) {
    const double position = 1e-4 * std::sin(0.05 * i);
    const double velocity = 1e-4 * 0.05 / 1e-3 * std::cos(0.05 * i);
    const double force = kSlider.force(position, velocity, anchor);
    const Eigen::Vector2d plane =
        kSlider.force(direction * position, direction * velocity, plane_anchor);
    EXPECT_LT((plane - force * direction).norm(), kRounding) << "step " << i;
  }
}

// Over any motion: what the slider gives the body ≤ what its spring held before − holds after.
TEST(SpringSlider, NeverAddsEnergy) {
  RandomStream random(2, 0);
  for (int path = 0; path < 20; ++path) {
    Eigen::Vector2d anchor(0.0, 0.0);
    Eigen::Vector2d position(0.0, 0.0);
    Eigen::Vector2d velocity(0.0, 0.0);
    double given = 0.0;
    for (int i = 0; i < 20000; ++i) {
      velocity += Eigen::Vector2d(random.normal(), random.normal()) * 2e-3;
      velocity *= 0.999;
      // Midpoint of the step, so that the sum is the integral to second order.
      given += kSlider.force(position + 0.5 * kStepS * velocity, velocity, anchor).dot(velocity) *
               kStepS;
      position += velocity * kStepS;
    }
    constexpr double kToleranceJ = 1e-10;  // of a limit × distance of 1e-5 J
    EXPECT_LE(given + kSlider.energy((position - anchor).norm(), 0.0), kToleranceJ);
    EXPECT_LT(given, -1e-7) << "the path was too short to slide";
  }
}

}  // namespace
}  // namespace limber
