#include "limber/world/collision.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "planning/dense_oracle.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr int kSamplesPerGap = 41;
constexpr double kSampleSpacingM = 0.235 / 5 / (kSamplesPerGap - 1);
constexpr double kFloatM = 1e-6;  // float32 over a 0.7 m arm

Backbone straight(const ArmDescription& arm) {
  return start_state(Environment{}, arm).backbone;
}

Backbone blend(const Backbone& a, const Backbone& b, double t) {
  return ((1.0 - t) * a.cast<double>() + t * b.cast<double>()).cast<float>();
}

TEST(CollisionChecker, ClearanceAgreesWithDenseSampling) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(1, 0);
  int collisions = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Backbone b = no_load_backbone(model, random_pressures(arm, random));
    std::vector<Obstacle> obstacles;
    for (int k = 0; k < 2; ++k) {
      obstacles.push_back(random_obstacle(random));
    }
    const CollisionChecker checker(arm, obstacles);
    const Clearance found = checker.clearance(b);
    const double sampled = oracle::clearance(arm, b, obstacles, kSamplesPerGap);
    EXPECT_LE(found.value_m, sampled + kFloatM) << trial;
    EXPECT_GE(found.value_m, sampled - kSampleSpacingM / 2 - CollisionChecker::kToleranceM)
        << trial;
    if (sampled < 0.0) {
      EXPECT_FALSE(checker.is_free(b)) << trial;
      ++collisions;
    } else if (sampled > kSampleSpacingM / 2 + CollisionChecker::kToleranceM) {
      EXPECT_TRUE(checker.is_free(b)) << trial;
    }
    EXPECT_NEAR(checker.clearance(b.cast<double>()).value_m, found.value_m, kFloatM);
    EXPECT_EQ(checker.is_free(b.cast<double>()), checker.is_free(b));
    EXPECT_NEAR(found.value_m,
                CollisionChecker(arm, {obstacles[static_cast<std::size_t>(found.obstacle)]})
                    .clearance(b)
                    .value_m,
                kFloatM);
  }
  EXPECT_GT(collisions, 30);
  EXPECT_LT(collisions, 120);
}

// The claim of the header on motions: none missed, false alarms only within kToleranceM of
// touching.
TEST(CollisionChecker, MotionsAgreeWithDenseSamplingInTime) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(2, 0);
  int missed_by_ends = 0;
  int free = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Pressures q = random_pressures(arm, random);
    Pressures next = q;
    for (int i = 0; i < 3; ++i) {
      next[i] += static_cast<float>(random.uniform(-20.0, 20.0));
    }
    const Backbone from = no_load_backbone(model, q);
    const Backbone to = no_load_backbone(model, next);
    // A thin pin right in the way of some plate: the ends of the motion seldom touch it.
    const int plate = 6 + static_cast<int>(random.index(10));
    const Backbone halfway = blend(from, to, random.uniform());
    const std::vector<Obstacle> obstacles{Circle{halfway(plate, 0) + random.uniform(-0.05, 0.05),
                                                 halfway(plate, 1) + random.uniform(-0.05, 0.05),
                                                 0.002}};
    const CollisionChecker checker(arm, obstacles);
    double sampled = std::numeric_limits<double>::max();
    constexpr int kInstants = 60;
    for (int k = 0; k <= kInstants; ++k) {
      sampled =
          std::min(sampled, checker.clearance(blend(from, to, double(k) / kInstants)).value_m);
    }
    const double way = (to - from).leftCols<2>().cast<double>().rowwise().norm().maxCoeff();
    const double between = 0.5 * way / kInstants + CollisionChecker::kToleranceM / 2;
    const bool is_free = checker.is_motion_free(from, to);
    if (sampled < 0.0) {
      EXPECT_FALSE(is_free) << trial;
      missed_by_ends += checker.is_free(from) && checker.is_free(to) ? 1 : 0;
    } else if (sampled > CollisionChecker::kToleranceM + between) {
      EXPECT_TRUE(is_free) << trial << ": " << sampled;
      ++free;
    }
    const double reported = checker.motion_clearance(from, to).value_m;
    // What is sampled is itself a bound from below.
    EXPECT_LE(reported, sampled + CollisionChecker::kToleranceM / 2) << trial;
    EXPECT_GE(reported, sampled - between - CollisionChecker::kToleranceM) << trial;
    if (is_free) {
      EXPECT_GT(reported, 0.0) << trial;
    }
    EXPECT_EQ(is_free, checker.is_motion_free(to, from)) << trial;
  }
  EXPECT_GT(missed_by_ends, 5) << "the test should hold motions that only their middle betrays";
  EXPECT_GT(free, 50);
}

// GapMotion::travel_bound_m: a point's place over a unit chord, by its turn.
TEST(CollisionChecker, PlaceOverTheChordChangesByLessThanThePostulatedAmount) {
  const auto place = [](double turn, double u) {
    const double a = 0.5 * turn;
    const double scale = 0.5 / std::sin(a);
    return Eigen::Vector2d(0.5 + std::sin(u * a) * scale, (std::cos(a) - std::cos(u * a)) * scale);
  };
  double largest = 0.0;
  constexpr double kStep = 1e-5;
  for (double turn = 0.01; turn < std::numbers::pi; turn += 0.01) {
    for (double u = -1.0; u <= 1.0; u += 0.02) {
      largest = std::max(largest, (place(turn, u) - place(turn - kStep, u)).norm() / kStep);
    }
  }
  EXPECT_LT(largest, 0.3);
  EXPECT_GT(largest, 0.2) << "the bound need not be much looser";
}

TEST(CollisionChecker, StraightArmBesideEachObstacleKindHasTheClearanceOfElementaryGeometry) {
  const ArmDescription arm = three_segment_arm();
  const Backbone b = straight(arm);
  const double first = 0.025 + 0.006;  // half width + actuator
  const double last = 0.0086 + 0.006;
  const auto clearance = [&](const Obstacle& obstacle) {
    return CollisionChecker(arm, {obstacle}).clearance(b);
  };
  const Clearance circle = clearance(Circle{0.1, 0.2, 0.05});
  EXPECT_NEAR(circle.value_m, 0.15 - first, kFloatM);
  EXPECT_EQ(circle.gap, 2);
  EXPECT_EQ(circle.obstacle, 0);
  const Clearance rectangle = clearance(Rectangle{0.6, -0.3, 0.02, 0.4, 0.0});
  EXPECT_NEAR(rectangle.value_m, 0.1 - last, kFloatM);
  EXPECT_EQ(rectangle.gap, 12);
  const Rectangle on_its_corner{0.705 + 0.05 + 0.1 * std::sqrt(2.0), 0.0, 0.2, 0.2,
                                std::numbers::pi / 4};
  EXPECT_NEAR(clearance(on_its_corner).value_m, 0.05 - last, kFloatM);
  // A U open toward the tip: the tip reaches into it without touching.
  const Polygon u{{{0.6, -0.2},
                   {0.6, -0.1},
                   {0.9, -0.1},
                   {0.9, 0.1},
                   {0.6, 0.1},
                   {0.6, 0.2},
                   {1.0, 0.2},
                   {1.0, -0.2}}};
  EXPECT_NEAR(clearance(u).value_m, 0.1 - last, kFloatM);
}

TEST(CollisionChecker, DepthIsNegativeInsideEachObstacleKind) {
  const ArmDescription arm = three_segment_arm();
  const Backbone b = straight(arm);
  const double first = 0.025 + 0.006;
  EXPECT_NEAR(CollisionChecker(arm, {Circle{0.1, 0.01, 0.05}}).clearance(b).value_m, -0.04 - first,
              kFloatM);
  constexpr double kDepthM = 2e-4;
  EXPECT_NEAR(CollisionChecker(arm, {Rectangle{0.1, 0.0, 0.04, 0.5, 0.0}}).clearance(b).value_m,
              -0.02 - first, kDepthM);
  EXPECT_NEAR(
      CollisionChecker(arm, {Polygon{{{0.05, -0.1}, {0.15, -0.1}, {0.15, 0.03}, {0.05, 0.03}}}})
          .clearance(b)
          .value_m,
      -0.03 - first, kDepthM);
}

TEST(CollisionChecker, TouchingCountsAsCollision) {
  const ArmDescription arm = three_segment_arm();
  const Backbone b = straight(arm);
  constexpr double kHairM = 1e-6;
  const double radius = 0.025 + 0.006;
  for (const double side : {1.0, -1.0}) {
    EXPECT_FALSE(
        CollisionChecker(arm, {Circle{0.1, side * (0.05 + radius - kHairM), 0.05}}).is_free(b));
    EXPECT_TRUE(
        CollisionChecker(arm, {Circle{0.1, side * (0.05 + radius + kHairM), 0.05}}).is_free(b));
    EXPECT_FALSE(
        CollisionChecker(arm, {Rectangle{0.1, side * (0.05 + radius - kHairM), 0.1, 0.1, 0.0}})
            .is_free(b));
    EXPECT_TRUE(
        CollisionChecker(arm, {Rectangle{0.1, side * (0.05 + radius + kHairM), 0.1, 0.1, 0.0}})
            .is_free(b));
  }
}

TEST(CollisionChecker, TheBaseCounts) {
  const ArmDescription arm = three_segment_arm();
  EXPECT_FALSE(CollisionChecker(arm, {Circle{-0.03, 0.0, 0.005}}).is_free(straight(arm)));
}

TEST(CollisionChecker, MarginIsTakenOffTheClearance) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Obstacle> obstacles{Circle{0.3, 0.2, 0.05}};
  const Backbone b = straight(arm);
  EXPECT_NEAR(CollisionChecker(arm, obstacles, 0.03).clearance(b).value_m,
              CollisionChecker(arm, obstacles).clearance(b).value_m - 0.03, kFloatM);
}

TEST(CollisionChecker, WithoutObstaclesEverythingIsFreeAndInfinitelyClear) {
  const ArmDescription arm = three_segment_arm();
  const CollisionChecker checker(arm, {});
  EXPECT_TRUE(checker.is_free(straight(arm)));
  EXPECT_EQ(checker.clearance(straight(arm)).value_m, std::numeric_limits<double>::infinity());
  EXPECT_EQ(checker.clearance(straight(arm)).obstacle, -1);
}

TEST(CollisionChecker, ABackboneThatIsNoNumberIsNeverFree) {
  const ArmDescription arm = three_segment_arm();
  const CollisionChecker far(arm, {Circle{5.0, 5.0, 0.1}});
  const CollisionChecker alone(arm, {});
  for (const float value :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const int plate : {0, 7, 15}) {
      for (const int coordinate : {0, 1, 2}) {
        Backbone b = straight(arm);
        b(plate, coordinate) = value;
        EXPECT_FALSE(far.is_free(b));
        EXPECT_FALSE(alone.is_free(b));
        EXPECT_FALSE(far.is_motion_free(straight(arm), b));
        EXPECT_FALSE(far.is_motion_free(b, straight(arm)));
        EXPECT_LT(far.clearance(b).value_m, 0.0);
      }
    }
  }
}

// No arc that turns by more joins two plates: there is no shape to keep free, as for a NaN.
TEST(CollisionChecker, AGapThatTurnsByMoreThanHalfATurnIsNeverFree) {
  const ArmDescription arm = three_segment_arm();
  const CollisionChecker far(arm, {Circle{5.0, 5.0, 0.1}});
  const CollisionChecker alone(arm, {});
  const auto turned = [&](int plate, float turn_rad) {
    Backbone b = straight(arm);
    b.bottomRows(arm.point_count() - plate).col(2).array() += turn_rad;
    return b;
  };
  for (const int plate : {1, 7, 15}) {
    for (const float turn_rad : {-3.2F, 3.2F, 6.3F}) {
      const Backbone b = turned(plate, turn_rad);
      EXPECT_FALSE(far.is_free(b));
      EXPECT_FALSE(far.is_free(b.cast<double>()));
      EXPECT_FALSE(alone.is_free(b));
      EXPECT_FALSE(far.is_motion_free(straight(arm), b));
      EXPECT_FALSE(far.is_motion_free(b, straight(arm)));
      EXPECT_LT(far.clearance(b).value_m, 0.0);
      EXPECT_LT(far.motion_clearance(straight(arm), b).value_m, 0.0);
    }
    const Backbone half = turned(plate, std::numbers::pi_v<float>);
    EXPECT_TRUE(far.is_free(half)) << "π in float32 is a little more than π";
    EXPECT_TRUE(far.is_motion_free(straight(arm), half));
  }
}

// It has more gaps than the broad phase takes at a time (broad_phase_test.cpp has each of them).
TEST(CollisionChecker, ALongArmIsLookedAtFromBaseToTip) {
  ArmDescription arm = three_segment_arm();
  for (Segment& segment : arm.segments) {
    segment.gaps = 22;
  }
  const Backbone b = straight(arm);
  const Backbone aside = (b.rowwise() + Eigen::RowVector3f(0.0F, 0.01F, 0.0F)).eval();
  for (int gap = 0; gap < arm.point_count() - 1; ++gap) {
    const double x = 0.5 * double(b(gap, 0) + b(gap + 1, 0));
    const double radius = CollisionChecker(arm, {}).radius_m(gap);
    const CollisionChecker touched(arm, {Circle{x, radius + 0.004, 0.005}});
    EXPECT_FALSE(touched.is_free(b)) << "gap " << gap;
    EXPECT_FALSE(touched.is_motion_free(b, aside)) << "gap " << gap;
    EXPECT_FALSE(touched.is_motion_free(aside, b)) << "gap " << gap;
    const CollisionChecker clear(arm, {Circle{x, 0.031 + 0.007, 0.005}});  // of the widest segment
    EXPECT_TRUE(clear.is_free(b)) << "gap " << gap;
  }
}

TEST(CollisionChecker, RefusesANegativeMargin) {
  EXPECT_THAT([] { CollisionChecker(three_segment_arm(), {}, -0.01); },
              ThrowsMessage<InputError>(HasSubstr("margin_m = -0.01; expected a distance")));
}

// Files can't hold them, programs can; nothing would collide with a NaN.
TEST(CollisionChecker, TakesNoObstacleThatIsNowhereOrHasNoSize) {
  const ArmDescription arm = three_segment_arm();
  for (const Obstacle& nothing :
       {Obstacle(Circle{std::nan(""), 0.0, 0.1}), Obstacle(Circle{0.3, 0.0, -0.1}),
        Obstacle(Rectangle{0.3, 0.0, 0.1, 0.0, 0.0}), Obstacle(Polygon{})}) {
    EXPECT_THAT(
        [&] {
          CollisionChecker(arm, {Circle{0.3, 0.3, 0.1}, nothing});
        },
        ThrowsMessage<InputError>(HasSubstr("obstacles[1]: expected finite numbers")));
  }
}

}  // namespace
}  // namespace limber
