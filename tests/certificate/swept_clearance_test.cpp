#include "src/certificate/swept_clearance.hpp"

#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdlib>
#include <numbers>
#include <thread>

#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/obstacle_shape.hpp"
#include "planning/dense_oracle.hpp"
#include "planning/play_model.hpp"
#include "src/certificate/covered_obstacle.hpp"
#include "src/certificate/frame_checks.hpp"

namespace limber {
namespace {

TEST(SweptClearance, AgreesWithDenseSamplingInSpaceAndTime) {
  constexpr double kToleranceM = 1e-4;
  constexpr int kSamplesPerGap = 13;
  constexpr int kInstants = 12;
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(2, 0);
  int touching = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Pressures q = random_pressures(arm, random);
    Pressures next = q;
    for (int i = 0; i < 3; ++i) {
      next[i] += static_cast<float>(random.uniform(-10.0, 10.0));
    }
    const Backbone from = no_load_backbone(model, q);
    const Backbone to = no_load_backbone(model, next);
    const std::vector<Obstacle> obstacles{random_obstacle(random), random_obstacle(random)};
    double sampled = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= kInstants; ++k) {
      const float t = float(k) / kInstants;
      sampled = std::min(
          sampled, oracle::clearance(arm, (1.0F - t) * from + t * to, obstacles, kSamplesPerGap));
    }
    const SweptClearance::Result found =
        SweptClearance(arm, obstacles, kToleranceM).over({shape_of(from), shape_of(to)});
    const double way = (to - from).leftCols<2>().cast<double>().rowwise().norm().maxCoeff();
    const double spacing = 0.047 / (kSamplesPerGap - 1) + way / kInstants;
    constexpr double kFloatM = 1e-6;
    EXPECT_LE(found.value_m, sampled + kFloatM) << trial;
    EXPECT_GE(found.value_m, sampled - spacing / 2 - kToleranceM - kFloatM) << trial;
    touching += sampled < 0.0 ? 1 : 0;
  }
  EXPECT_GT(touching, 3);
  EXPECT_LT(touching, 17);
}

// Beside the middle of a gap, where no plate is near, while a plate is near another obstacle: that
// one the search starts from.
TEST(SweptClearance, LooksAtEveryGapAndNotAtPlatesAlone) {
  constexpr double kToleranceM = 1e-5;
  constexpr double kNearM = 0.001;
  constexpr double kLessNearM = 0.002;
  constexpr double kCircleM = 0.003;
  ArmDescription arm = three_segment_arm();
  for (Segment& segment : arm.segments) {
    segment.width_m = 0.03;
  }
  const double height_m = 0.015 + arm.actuator_radius_m + kCircleM;
  const Backbone straight = no_load_backbone(NoLoadModel(arm), Pressures::Zero(3));
  const int gaps = arm.point_count() - 1;
  for (int gap = 0; gap < gaps; ++gap) {
    const double middle_m = 0.5 * double(straight(gap, 0) + straight(gap + 1, 0));
    const int far = (gap + gaps / 2) % gaps;
    const std::vector<Obstacle> obstacles{
        Circle{middle_m, height_m + kNearM, kCircleM},
        Circle{double(straight(far, 0)), height_m + kLessNearM, kCircleM}};
    const SweptClearance::Result found =
        SweptClearance(arm, obstacles, kToleranceM).over({shape_of(straight)});
    EXPECT_NEAR(found.value_m, kNearM, 2.0 * kToleranceM) << gap;
    EXPECT_EQ(found.gap, gap);
    EXPECT_EQ(found.obstacle, 0);
  }
}

/// A star about the origin, whose outline the ray from a point meets many times.
Polygon star(int corners, double inner_m, double outer_m) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    const double radius = i % 2 == 0 ? outer_m : inner_m;
    polygon.points_m.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

// Room that grows from the first shape: as the planner's own checker has it, which shares no code.
TEST(SweptClearance, WithGrowingRoomAgreesWithTheCollisionChecker) {
  constexpr double kToleranceM = 1e-4;
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  const std::vector<double> full_m(16, 0.03);
  RandomStream random(3, 0);
  double least_growth_m = 0.03;
  for (int trial = 0; trial < 30; ++trial) {
    const Pressures q = random_pressures(arm, random);
    Pressures next = q;
    for (int i = 0; i < 3; ++i) {
      next[i] += static_cast<float>(random.uniform(-20.0, 20.0));
    }
    const Backbone from = no_load_backbone(model, q);
    const Backbone to = no_load_backbone(model, next);
    const std::vector<Obstacle> obstacles{random_obstacle(random), random_obstacle(random)};
    const SweptClearance::Result found =
        SweptClearance(arm, obstacles, kToleranceM)
            .over({shape_of(from), shape_of(to)}, {}, {full_m, 0.2, 0.1});
    const CollisionChecker checker(arm, obstacles, 0.0, {full_m, {0.2, 0.1}, from});
    const double expected =
        std::min(checker.clearance(from).value_m, checker.motion_clearance(from, to).value_m);
    EXPECT_NEAR(found.value_m, expected, CollisionChecker::kToleranceM + kToleranceM) << trial;
    const CollisionChecker everywhere(arm, obstacles, 0.0, {full_m});
    least_growth_m =
        std::min(least_growth_m, expected - everywhere.motion_clearance(from, to).value_m);
    EXPECT_GE(expected, everywhere.motion_clearance(from, to).value_m - 1e-9) << trial;
  }
  EXPECT_LT(least_growth_m, 0.01);
}

TEST(SweptClearance, DistanceToAnOutlineIsThatOverAllItsEdges) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(3, 0);
  for (const int corners : {4, 16, 18, 34, 1000}) {
    const Polygon polygon = star(corners, 0.05, 0.15);
    const PolygonOutline outline(polygon);
    const ObstacleShape slow = make_obstacle_shape(polygon, 0);
    int inside = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const Eigen::Vector2d p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const double expected = signed_distance(slow, p);
      EXPECT_NEAR(outline.read({p.x(), p.y()}).distance_m, expected, kRoundingM) << corners;
      inside += expected < 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, 10);
    EXPECT_LT(inside, 200);
  }
}

/// Simple, not convex, and as ragged as its corners are many.
Polygon ragged_polygon(int corners, RandomStream& random) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform(0.0, 0.9)) / corners;
    const double radius = 0.1 + 0.04 * std::sin(3.0 * angle) + random.uniform(0.0, 0.03);
    polygon.points_m.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/// All edges, one by one: distance to the outline, negative where a ray meets it an odd number of
/// times.
double brute_force_distance(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d ab = corners[(i + 1) % corners.size()] - a;
    const double along = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - along * ab).norm());
    const double height = p.y() - a.y();
    if ((height < 0.0) != (height < ab.y()) && p.x() < a.x() + ab.x() * height / ab.y()) {
      inside = !inside;
    }
  }
  return inside ? -nearest : nearest;
}

TEST(PolygonOutline, AThousandRandomCornersAreReadAsByBruteForce) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(4, 0);
  int inside = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Polygon polygon = ragged_polygon(1000, random);
    if (trial % 2 == 0) {
      std::reverse(polygon.points_m.begin(), polygon.points_m.end());
    }
    const PolygonOutline outline(polygon);
    EXPECT_FALSE(outline.is_convex());
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2d p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const double expected = brute_force_distance(polygon.points_m, p);
      EXPECT_NEAR(outline.read({p.x(), p.y()}).distance_m, expected, kRoundingM)
          << trial << ' ' << i;
      inside += expected < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, 3500);
}

// The bound that convex obstacles are skipped by: from any point to any other, inside or outside.
TEST(CoveredObstacle, AConvexOneLiesBehindAStraightLine) {
  constexpr double kRoundingM = 1e-12;
  RandomStream random(5, 0);
  Polygon round;
  for (int i = 0; i < 50; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 50;
    round.points_m.emplace_back(0.1 * std::cos(angle), 0.07 * std::sin(angle));
  }
  Polygon reversed = round;
  std::reverse(reversed.points_m.begin(), reversed.points_m.end());
  EXPECT_TRUE(PolygonOutline(round).is_convex());
  EXPECT_TRUE(PolygonOutline(reversed).is_convex());
  // A pentagram turns to one side only, but twice.
  Polygon pentagram;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4.0 * std::numbers::pi * i / 5;
    pentagram.points_m.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle));
  }
  EXPECT_FALSE(PolygonOutline(pentagram).is_convex());
  for (const Obstacle& obstacle :
       {Obstacle(Circle{0.01, 0.02, 0.08}), Obstacle(Rectangle{0.02, -0.01, 0.15, 0.06, 0.7}),
        Obstacle(round), Obstacle(reversed)}) {
    const CoveredObstacle covered(obstacle);
    for (int i = 0; i < 2000; ++i) {
      const std::complex<double> p(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const std::complex<double> q(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
      const Reading reading = covered.read(p);
      ASSERT_NEAR(std::abs(reading.away), 1.0, kRoundingM);
      const double bound = reading.distance_m + ((q - p) * std::conj(reading.away)).real();
      EXPECT_GE(covered.read(q).distance_m, bound - kRoundingM) << obstacle_kind(obstacle);
    }
  }
}

/// Sweeps for a second or more, and is sent a signal soon after it began.
[[noreturn]] void sweep_with_signal() {
  constexpr auto kSoon = std::chrono::milliseconds(50);
  const ArmDescription arm = three_segment_arm();
  const ExactArm::Shape shape =
      shape_of(no_load_backbone(NoLoadModel(arm), Pressures::Constant(3, 20.0F)));
  const std::vector<Obstacle> obstacles(300, star(1000, 0.05, 0.15));
  const SweptClearance sweep(arm, obstacles, Certificate::kClearanceToleranceM);
  const std::vector<ExactArm::Shape> shapes(20'000, shape);
  install_interrupt_handler();
  std::thread([kSoon] {
    std::this_thread::sleep_for(kSoon);
    (void)std::raise(SIGINT);
  }).detach();
  try {
    (void)sweep.over(shapes);
  } catch (const Interrupted&) {
    // Asked again by one who knows of the signal: done to its end.
    std::_Exit(std::isfinite(sweep.over({shape}).value_m) ? 0 : 2);
  }
  std::_Exit(3);
}

// In a process of its own, for the signal's flag stays set.
TEST(SweptClearanceDeathTest, StopsOnASignalThatComesMeanwhileAndOnlyThen) {
  EXPECT_EXIT(sweep_with_signal(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace limber
