#include "limber/arm/backbone.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-13;        // [m, rad] of double poses of some units
constexpr float kFloatRounding = 1e-5F;    // [m, rad] of float poses of some units
constexpr double kIntegrationStep = 1e-9;  // [m], the midpoint rule's error over kSteps steps
constexpr int kSteps = 20'000;

Pose random_pose(RandomStream& random) {
  return {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-7.0, 7.0)};
}

double largest_difference(const Pose& a, const Pose& b) {
  return (numbers_of(a) - numbers_of(b)).cwiseAbs().maxCoeff();
}

TEST(Pose, TheOriginChangesNothing) {
  RandomStream random(1, 0);
  const Pose pose = random_pose(random);
  EXPECT_EQ(largest_difference(compose(Pose{}, pose), pose), 0.0);
  EXPECT_EQ(largest_difference(compose(pose, Pose{}), pose), 0.0);
  EXPECT_EQ(largest_difference(between(Pose{}, pose), pose), 0.0);
  EXPECT_LT(largest_difference(between(pose, pose), Pose{}), kRounding);
}

TEST(Pose, ComposingIsAssociative) {
  RandomStream random(2, 0);
  for (int k = 0; k < 100; ++k) {
    const Pose a = random_pose(random), b = random_pose(random), c = random_pose(random);
    EXPECT_LT(largest_difference(compose(compose(a, b), c), compose(a, compose(b, c))), kRounding);
  }
}

TEST(Pose, BetweenUndoesCompose) {
  RandomStream random(3, 0);
  for (int k = 0; k < 100; ++k) {
    const Pose a = random_pose(random), b = random_pose(random);
    EXPECT_LT(largest_difference(between(a, compose(a, b)), b), kRounding);
    EXPECT_LT(largest_difference(compose(a, between(a, b)), b), kRounding);
  }
}

TEST(Pose, HeadingsAddUpBeyondAFullTurn) {
  const Pose turned = compose(Pose{0.0, 0.0, 5.0}, Pose{0.0, 0.0, 5.0});
  EXPECT_EQ(turned.theta_rad, 10.0);
  EXPECT_EQ(between(turned, Pose{}).theta_rad, -10.0);
}

TEST(Pose, AQuarterTurnTakesXToY) {
  const Pose moved = compose(Pose{1.0, 2.0, 0.5 * std::numbers::pi}, Pose{3.0, 0.0, 0.1});
  EXPECT_LT(largest_difference(moved, {1.0, 5.0, 0.5 * std::numbers::pi + 0.1}), kRounding);
}

TEST(Pose, FloatsAreTheDoublesRounded) {
  RandomStream random(4, 0);
  const Pose a = random_pose(random), b = random_pose(random);
  const auto rounded = [](const Pose& pose) {
    return PoseOf<float>{float(pose.x_m), float(pose.y_m), float(pose.theta_rad)};
  };
  const auto near = [](const PoseOf<float>& is, const Pose& expected) {
    return (numbers_of(is).cast<double>() - numbers_of(expected)).norm() < double(kFloatRounding);
  };
  EXPECT_TRUE(near(compose(rounded(a), rounded(b)), compose(a, b)));
  EXPECT_TRUE(near(between(rounded(a), rounded(b)), between(a, b)));
  EXPECT_TRUE(near(arc(0.7F, 1.2F), arc(0.7, 1.2)));
}

// The same by small straight steps along the tangent.
TEST(Arc, IsTheIntegralOfItsHeading) {
  for (const double angle_rad : {-2.5, -0.05, 0.0, 1e-8, 0.3, 4.0}) {
    constexpr double kLengthM = 0.7;
    Pose pose;
    for (int k = 0; k < kSteps; ++k) {
      const double middle_rad = (k + 0.5) / kSteps * angle_rad;
      pose.x_m += kLengthM / kSteps * std::cos(middle_rad);
      pose.y_m += kLengthM / kSteps * std::sin(middle_rad);
    }
    pose.theta_rad = angle_rad;
    EXPECT_LT(largest_difference(arc(kLengthM, angle_rad), pose), kIntegrationStep) << angle_rad;
  }
}

TEST(Arc, TwoHalvesAreTheWhole) {
  for (const double angle_rad : {-3.0, -0.19, 0.0, 0.19, 1.0}) {
    const Pose half = arc(0.35, 0.5 * angle_rad);
    EXPECT_LT(largest_difference(compose(half, half), arc(0.7, angle_rad)), kRounding);
  }
}

// A chord of l·sin(a/2)/(a/2) that leaves at half the turn.
TEST(Arc, ItsChordHasItsShareOfTheLength) {
  for (const double angle_rad : {-4.0, -0.05, 0.0, 1e-300, 0.2, 3.0}) {
    const Pose end = arc(0.7, angle_rad);
    const Pose chord = compose(Pose{0.0, 0.0, 0.5 * angle_rad},
                               Pose{0.7 * chord_share(angle_rad), 0.0, 0.5 * angle_rad});
    EXPECT_LT(largest_difference(end, chord), kRounding) << angle_rad;
  }
}

TEST(Arc, SeriesMeetsClosedForm) {
  constexpr double kBelow = 0.1 - 1e-12;
  constexpr double kAbove = 0.1 + 1e-12;
  const Eigen::Vector2d difference = arc_end(1.0, kAbove) - arc_end(1.0, kBelow);
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 3e-12);
  EXPECT_EQ(arc_end(2.0, 0.0), Eigen::Vector2d(2.0, 0.0));
}

}  // namespace
}  // namespace limber
