#include "limber/arm/no_load_model.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kRounding = 1e-13;      // [m], [rad]; double over a 1 m arm
constexpr double kFloatRounding = 2e-6;  // [m], [rad]; float over a 1 m arm bent by a few turns

double polynomial(const StrainPolynomial& c, double p) {
  return c[0] * p + c[1] * p * p + c[2] * p * p * p + c[3] * p * p * p * p;
}

BackboneD backbone_of(const NoLoadModel& model, const Eigen::VectorXd& pressures_kpa) {
  BackboneD backbone = BackboneD::Constant(model.point_count(), 3, std::nan(""));
  model.backbone(pressures_kpa, backbone);
  return backbone;
}

Eigen::VectorXd random_pressures(const NoLoadModel& model, RandomStream& random) {
  Eigen::VectorXd pressures(model.segment_count());
  for (int i = 0; i < model.segment_count(); ++i) {
    pressures[i] = model.segment(i).pressure_limit_kpa.largest_kpa() * random.uniform(-1.0, 1.0);
  }
  return pressures;
}

TEST(NoLoadModel, ZeroPressureIsStraight) {
  const ArmDescription arm = arm_of(4);
  const NoLoadModel model(arm);
  const BackboneD backbone = backbone_of(model, Eigen::VectorXd::Zero(4));
  int point = 0;
  double x = 0.0;
  for (const Segment& s : arm.segments) {
    for (int g = 0; g < s.gaps; ++g) {
      x += s.length_m / s.gaps;
      EXPECT_NEAR(backbone(++point, 0), x, kRounding);
    }
  }
  EXPECT_EQ(point, model.point_count() - 1);
  EXPECT_EQ(backbone.col(1).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(backbone.col(2).cwiseAbs().maxCoeff(), 0.0);
}

// (3), (4): the contracted side is e·l0 shorter than the other, a width t apart, so the segment
// turns by e·l0/t, to the right (−θ) under positive pressure; its middle is e/2 shorter.
TEST(NoLoadModel, SegmentTurnsByItsContractionOverItsWidth) {
  const ArmDescription arm = arm_of(3);
  const NoLoadModel model(arm);
  for (int i = 0; i < 3; ++i) {
    const Segment& s = arm.segments[std::size_t(i)];
    for (double p : {-70.0, -3.0, 0.5, 40.0, 85.0}) {
      const double e = polynomial(s.strain_polynomial, std::abs(p));
      const SegmentShape shape = model.segment_shape(i, p);
      EXPECT_NEAR(shape.curvature_per_m * shape.length_m,
                  (p > 0.0 ? -e : e) * s.length_m / s.width_m, kRounding);
      EXPECT_NEAR(shape.length_m, s.length_m * (1.0 - 0.5 * e), kRounding);
      // The printed (3), with the strain ε = −e of the side that contracts.
      EXPECT_NEAR(std::abs(shape.curvature_per_m), 1.0 / (-s.width_m / -e - 0.5 * s.width_m), 1e-9);
    }
  }
}

// Two arcs by hand, ends only: an oracle that shares no code with the chain of gaps.
TEST(NoLoadModel, TipIsTheChainOfWholeArcs) {
  const NoLoadModel model(arm_of(3));
  RandomStream random(31, 0);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd pressures = random_pressures(model, random);
    double x = 0.0;
    double y = 0.0;
    double theta = 0.0;
    for (int i = 0; i < 3; ++i) {
      const SegmentShape shape = model.segment_shape(i, pressures[i]);
      const double turned = theta + shape.curvature_per_m * shape.length_m;
      // The arc's end by its centre of curvature.
      x += (std::sin(turned) - std::sin(theta)) / shape.curvature_per_m;
      y -= (std::cos(turned) - std::cos(theta)) / shape.curvature_per_m;
      theta = turned;
    }
    const Pose tip = tip_pose(backbone_of(model, pressures));
    EXPECT_NEAR(tip.x_m, x, 1e-11);  // 1/κ loses digits in the oracle, not in the model
    EXPECT_NEAR(tip.y_m, y, 1e-11);
    EXPECT_NEAR(tip.theta_rad, theta, kRounding);
  }
}

TEST(NoLoadModel, OppositePressuresAreMirrorImages) {
  const NoLoadModel model(arm_of(5));
  RandomStream random(32, 0);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd pressures = random_pressures(model, random);
    const BackboneD right = backbone_of(model, pressures);
    const BackboneD left = backbone_of(model, -pressures);
    EXPECT_EQ(right.col(0), left.col(0));
    EXPECT_EQ(right.col(1), -left.col(1));
    EXPECT_EQ(right.col(2), -left.col(2));
  }
}

TEST(NoLoadModel, ThetaIsUnwrapped) {
  const NoLoadModel model(arm_of(5));
  Eigen::VectorXd pressures(5);
  for (int i = 0; i < 5; ++i) {
    pressures[i] = -model.segment(i).pressure_limit_kpa.largest_kpa();
  }
  const BackboneD backbone = backbone_of(model, pressures);
  EXPECT_GT(tip_pose(backbone).theta_rad, 2.0 * M_PI);
  for (int point = 1; point < model.point_count(); ++point) {
    EXPECT_GT(backbone(point, 2), backbone(point - 1, 2));
  }
}

// l and the tip have a kink at p = 0, values and the turn have none: one-sided slopes.
TEST(NoLoadModel, HasAKinkInLengthAndNoneInAngleAtZeroPressure) {
  const ArmDescription arm = arm_of(1);
  const NoLoadModel model(arm);
  const Segment& s = arm.segments[0];
  constexpr double kStep = 1e-6;        // [kPa]
  constexpr double kSlopeError = 1e-8;  // [m/kPa], [rad/kPa]: kStep times the second derivative
  const auto tip = [&](double p) {
    return tip_pose(backbone_of(model, Eigen::VectorXd::Constant(1, p)));
  };
  const double c1 = s.strain_polynomial[0];
  const double x_above = (tip(kStep).x_m - tip(0.0).x_m) / kStep;
  const double x_below = (tip(0.0).x_m - tip(-kStep).x_m) / kStep;
  EXPECT_NEAR(x_above, -0.5 * c1 * s.length_m, kSlopeError);
  EXPECT_NEAR(x_below, 0.5 * c1 * s.length_m, kSlopeError);
  const double theta_above = (tip(kStep).theta_rad - tip(0.0).theta_rad) / kStep;
  const double theta_below = (tip(0.0).theta_rad - tip(-kStep).theta_rad) / kStep;
  EXPECT_NEAR(theta_above, -c1 * s.length_m / s.width_m, kSlopeError);
  EXPECT_NEAR(theta_above, theta_below, kSlopeError);
}

TEST(NoLoadModel, PressureForCurvatureIsTheInverse) {
  const NoLoadModel model(arm_of(3));
  for (int i = 0; i < 3; ++i) {
    const double limit = model.segment(i).pressure_limit_kpa.largest_kpa();
    for (double p = -limit; p <= limit; p += limit / 37.0) {
      const double curvature = model.segment_shape(i, p).curvature_per_m;
      const SegmentPressure back = model.pressure_for_curvature(i, 0.999999 * curvature);
      EXPECT_TRUE(back.reachable);
      EXPECT_NEAR(back.pressure_kpa, p, 1e-3);
      EXPECT_NEAR(model.segment_shape(i, back.pressure_kpa).curvature_per_m, 0.999999 * curvature,
                  1e-11);
    }
  }
}

TEST(NoLoadModel, FlagsCurvaturesBeyondThePressureLimit) {
  const NoLoadModel model(arm_of(2));
  const double limit = model.curvature_limit_per_m(1);
  EXPECT_TRUE(model.pressure_for_curvature(1, 0.999 * limit).reachable);
  const SegmentPressure right = model.pressure_for_curvature(1, -1.001 * limit);
  EXPECT_FALSE(right.reachable);
  EXPECT_EQ(right.pressure_kpa, model.segment(1).pressure_limit_kpa.largest_kpa());
  EXPECT_EQ(model.pressure_for_curvature(1, 1.001 * limit).pressure_kpa, -right.pressure_kpa);
}

// Either side bends by the same polynomial as far as its own limit.
TEST(NoLoadModel, StopsAtTheLimitOfEachSide) {
  ArmDescription arm = arm_of(1);
  const NoLoadModel symmetric(arm);
  const double full = arm.segments[0].pressure_limit_kpa.largest_kpa();
  const double lower = -0.4 * full;
  arm.segments[0].pressure_limit_kpa = {lower, full};
  const NoLoadModel model(arm);
  EXPECT_EQ(model.curvature_limit_per_m(0), symmetric.curvature_limit_per_m(0));
  const double left = symmetric.segment_shape(0, lower).curvature_per_m;  // positive, by (3)
  EXPECT_TRUE(model.pressure_for_curvature(0, 0.999 * left).reachable);
  EXPECT_FALSE(model.pressure_for_curvature(0, 1.001 * left).reachable);
  EXPECT_EQ(model.pressure_for_curvature(0, 1.001 * left).pressure_kpa, lower);
  EXPECT_TRUE(model.pressure_for_curvature(0, -1.001 * left).reachable);
  for (const double p : {lower, 0.5 * lower, 0.0, 0.5 * full, full}) {
    EXPECT_EQ(model.segment_shape(0, p).curvature_per_m,
              symmetric.segment_shape(0, p).curvature_per_m);
  }
  arm.segments[0].pressure_limit_kpa = {0.0, full};
  EXPECT_EQ(NoLoadModel(arm).pressure_for_curvature(0, 0.1 * left).pressure_kpa, 0.0);
}

TEST(NoLoadModel, LengthForCurvatureAgreesWithTheShape) {
  const NoLoadModel model(arm_of(3));
  for (double p : {-90.0, -20.0, 0.0, 5.0, 60.0}) {
    const SegmentShape shape = model.segment_shape(2, p);
    EXPECT_NEAR(model.length_for_curvature(2, shape.curvature_per_m), shape.length_m, kRounding);
  }
}

// A measured pressure may overshoot its limit: the strain goes on along the end slope.
TEST(NoLoadModel, StrainContinuesStraightAboveTheLimit) {
  const ArmDescription arm = arm_of(1);
  const NoLoadModel model(arm);
  const double limit = arm.segments[0].pressure_limit_kpa.largest_kpa();
  const double slope = (model.strain(0, limit) - model.strain(0, limit - 1e-6)) / 1e-6;
  EXPECT_GT(slope, 0.0);
  EXPECT_NEAR(model.strain(0, limit + 3.0), model.strain(0, limit) + 3.0 * slope, 1e-8);
}

TEST(NoLoadModel, FloatAndDoubleAgree) {
  const NoLoadModel model(arm_of(5));
  RandomStream random(33, 0);
  for (int trial = 0; trial < 100; ++trial) {
    const Pressures pressures = random_pressures(model, random).cast<float>();
    Backbone single(model.point_count(), 3);
    model.backbone(pressures, single);
    const BackboneD exact = backbone_of(model, pressures.cast<double>());
    EXPECT_LT((single.cast<double>() - exact).cwiseAbs().maxCoeff(), kFloatRounding);
  }
}

TEST(NoLoadModel, RefusesAPolynomialThatFallsOrFoldsTheSegment) {
  ArmDescription arm = arm_of(2);
  arm.segments[1].strain_polynomial = {1e-2, -1e-4, 0.0, 0.0};  // turns down at 50 kPa
  EXPECT_THAT([&] { NoLoadModel model(arm); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("segments[1].strain_polynomial falls at"), HasSubstr("95 kPa"))));
  arm.segments[1].strain_polynomial = {2e-2, 0.0, 0.0, 0.0};
  EXPECT_THAT([&] { NoLoadModel model(arm); },
              ThrowsMessage<InputError>(HasSubstr("gives a strain of 1.9 at the limit")));
  arm.segments[1].strain_polynomial = {0.0, 0.0, 0.0, 0.0};
  EXPECT_THAT([&] { NoLoadModel model(arm); },
              ThrowsMessage<InputError>(HasSubstr("expected between 0 and 1")));
}

// (17): curvature is the command times its factor, and the length stays.
TEST(NoLoadModel, CurvatureArmsBendInProportionToTheirCommand) {
  const ArmDescription arm = curvature_arm_of(3);
  const NoLoadModel model(arm);
  RandomStream random(3, 0);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::VectorXd q = random_pressures(model, random);
    const BackboneD backbone = backbone_of(model, q);
    double heading = 0.0;
    for (int i = 0; i < 3; ++i) {
      const Segment& s = arm.segments[std::size_t(i)];
      heading += s.curvature_per_unit * q[i] * s.length_m;
      EXPECT_EQ(model.segment_shape(i, q[i]).length_m, s.length_m);
      const SegmentPressure back =
          model.pressure_for_curvature(i, model.segment_shape(i, q[i]).curvature_per_m);
      EXPECT_NEAR(back.pressure_kpa, q[i], kRounding);
      EXPECT_TRUE(back.reachable);
    }
    EXPECT_NEAR(backbone(model.point_count() - 1, 2), heading, kRounding);
  }
  const double limit = model.curvature_limit_per_m(1);
  EXPECT_TRUE(model.pressure_for_curvature(1, limit).reachable);
  const SegmentPressure beyond = model.pressure_for_curvature(1, 1.01 * limit);
  EXPECT_FALSE(beyond.reachable);
  EXPECT_EQ(beyond.pressure_kpa, -1.5);
}

// (18): nothing bends the unloaded arm.
TEST(NoLoadModel, StraightArmsStayStraight) {
  ArmDescription arm = curvature_arm_of(2);
  arm.no_load = NoLoadKind::straight;
  const NoLoadModel model(arm);
  EXPECT_EQ(backbone_of(model, Eigen::Vector2d(1.0, -1.5)),
            backbone_of(model, Eigen::Vector2d::Zero()));
  EXPECT_EQ(model.pressure_for_curvature(0, 1.0).pressure_kpa, 0.0);
  EXPECT_FALSE(model.pressure_for_curvature(0, 1.0).reachable);
}

}  // namespace
}  // namespace limber
