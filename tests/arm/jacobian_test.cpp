#include "limber/arm/jacobian.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kStep = 1e-6;              // [1/m] of the differences
constexpr double kDifferencesError = 2e-9;  // [m per 1/m]; kStep² truncation, 1e-16/kStep rounding
constexpr double kOneSidedError = 1e-7;     // one-sided differences err by kStep times J'
constexpr double kRounding = 1e-14;

Eigen::Vector3d vector(const Pose& pose) {
  return {pose.x_m, pose.y_m, pose.theta_rad};
}

SegmentVector random_curvatures(const NoLoadModel& model, RandomStream& random) {
  SegmentVector curvatures(model.segment_count());
  for (int i = 0; i < model.segment_count(); ++i) {
    curvatures[i] = model.curvature_limit_per_m(i) * random.uniform(-1.0, 1.0);
  }
  return curvatures;
}

/// Differences of the tip pose in curvature i, taken on `below` and `above` steps of its sides.
Eigen::Vector3d difference(const NoLoadModel& model, SegmentVector curvatures, int i, double below,
                           double above) {
  const double centre = curvatures[i];
  curvatures[i] = centre + above;
  const Eigen::Vector3d high = vector(tip_at_curvatures(model, curvatures));
  curvatures[i] = centre - below;
  return (high - vector(tip_at_curvatures(model, curvatures))) / (above + below);
}

class JacobianOfArm : public ::testing::TestWithParam<int> {};

TEST_P(JacobianOfArm, TipJacobianEqualsCentralDifferences) {
  const NoLoadModel model(arm_of(GetParam()));
  RandomStream random(11, 0);
  PlanarJacobian jacobian;
  Pose tip;
  for (int trial = 0; trial < 200; ++trial) {
    const SegmentVector curvatures = random_curvatures(model, random);
    tip_jacobian(model, curvatures, jacobian, tip);
    ASSERT_EQ(jacobian.cols(), GetParam());
    EXPECT_EQ(vector(tip), vector(tip_at_curvatures(model, curvatures)));
    for (int i = 0; i < GetParam(); ++i) {
      const Eigen::Vector3d expected = difference(model, curvatures, i, kStep, kStep);
      EXPECT_LT((jacobian.col(i) - expected).cwiseAbs().maxCoeff(), kDifferencesError) << trial;
      EXPECT_GT(expected.norm(), 1e-3);  // a comparison of zeros would prove nothing
    }
  }
}

TEST_P(JacobianOfArm, IsOneSidedWhereASegmentIsStraight) {
  const NoLoadModel model(arm_of(GetParam()));
  RandomStream random(12, 0);
  PlanarJacobian jacobian;
  Pose tip;
  for (int trial = 0; trial < 20; ++trial) {
    for (int i = 0; i < GetParam(); ++i) {
      SegmentVector curvatures = random_curvatures(model, random);
      curvatures[i] = 0.0;
      tip_jacobian(model, curvatures, jacobian, tip);
      const Eigen::Vector3d above = jacobian.col(i);
      EXPECT_LT((above - difference(model, curvatures, i, 0.0, kStep)).cwiseAbs().maxCoeff(),
                kOneSidedError);
      curvatures[i] = -0.0;
      tip_jacobian(model, curvatures, jacobian, tip);
      const Eigen::Vector3d below = jacobian.col(i);
      EXPECT_LT((below - difference(model, curvatures, i, kStep, 0.0)).cwiseAbs().maxCoeff(),
                kOneSidedError);
      // The kink itself: the two sides differ by 2 D along the segment, (6) at κ = 0.
      const Segment& s = model.segment(i);
      EXPECT_NEAR((above - below).head<2>().norm(), s.length_m * s.width_m, kRounding);
    }
  }
}

TEST_P(JacobianOfArm, IsSmoothThroughTheSwitchFromSeriesToClosedForm) {
  const NoLoadModel model(arm_of(GetParam()));
  for (int i = 0; i < GetParam(); ++i) {
    const double switch_over = 0.1 / model.segment(i).length_m;
    for (double curvature = 0.9 * switch_over; curvature < 1.1 * switch_over;
         curvature += 0.01 * switch_over) {
      const double step = 1e-7;
      const Eigen::Vector3d change =
          segment_twist(model, i, curvature + step) - segment_twist(model, i, curvature - step);
      EXPECT_LT(change.cwiseAbs().maxCoeff(), 1e-8) << curvature;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Segments, JacobianOfArm, ::testing::Values(1, 2, 3, 5));

// What the series leaves out is below rounding, as the closed form of (7) in more digits says.
TEST(SegmentTwist, HasEveryDigitWhereItsSeriesEnds) {
  const NoLoadModel model(curvature_arm_of(1));  // its length stays: (7) is the arc's alone
  const long double length = model.segment(0).length_m;
  constexpr double kSeriesError = 1e-13;  // relative
  for (const long double angle : {-0.0999L, -0.08L, 0.09L, 0.0999L}) {
    const Eigen::Vector3d twist = segment_twist(model, 0, static_cast<double>(angle / length));
    const long double size = length * length / (angle * angle);
    EXPECT_NEAR(static_cast<double>(twist[0] / (size * (angle - std::sin(angle)))), 1.0,
                kSeriesError);
    EXPECT_NEAR(static_cast<double>(twist[1] / (size * (std::cos(angle) - 1.0L))), 1.0,
                kSeriesError);
  }
}

// (6): the slope of (3) in (4), on both sides of zero and away from it.
TEST(LengthSlope, IsTheDerivativeOfLength) {
  const NoLoadModel model(arm_of(2));
  for (double curvature : {-4.0, -0.3, 0.3, 4.0}) {
    const double expected = (model.length_for_curvature(1, curvature + kStep) -
                             model.length_for_curvature(1, curvature - kStep)) /
                            (2.0 * kStep);
    EXPECT_NEAR(length_slope(model, 1, curvature), expected, kDifferencesError);
  }
  const Segment& s = model.segment(1);
  EXPECT_DOUBLE_EQ(length_slope(model, 1, 0.0), -s.length_m * s.width_m / 2.0);
  EXPECT_DOUBLE_EQ(length_slope(model, 1, -0.0), s.length_m * s.width_m / 2.0);
}

// The rigid part of a twist: about the base, a pure turn of the base itself moves the tip by ω × p.
TEST(SpatialJacobian, FirstColumnIsTheFirstSegmentsTwistWhateverFollows) {
  const NoLoadModel model(arm_of(3));
  SegmentVector curvatures(3);
  curvatures << 2.0, -3.0, 1.0;
  PlanarJacobian jacobian;
  Pose tip;
  spatial_jacobian(model, curvatures, jacobian, tip);
  EXPECT_EQ(Eigen::Vector3d(jacobian.col(0)), segment_twist(model, 0, 2.0));
  // All segments turn the tip about the same axis, each by l + κD.
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(jacobian(2, i),
                model.length_for_curvature(i, curvatures[i]) +
                    curvatures[i] * length_slope(model, i, curvatures[i]),
                kRounding);
  }
}

TEST(TipJacobian, EqualsDifferencesWhereTheLengthStays) {
  const NoLoadModel model(curvature_arm_of(3));
  RandomStream random(5, 0);
  PlanarJacobian jacobian;
  Pose tip;
  for (int trial = 0; trial < 50; ++trial) {
    const SegmentVector curvatures = random_curvatures(model, random);
    tip_jacobian(model, curvatures, jacobian, tip);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LT(
          (jacobian.col(i) - difference(model, curvatures, i, kStep, kStep)).cwiseAbs().maxCoeff(),
          kDifferencesError);
    }
  }
}

}  // namespace
}  // namespace limber
