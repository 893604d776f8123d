#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/world/collision.hpp"
#include "planning/dense_oracle.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kFloatM = 1e-6;  // float32 over a 0.7 m arm

std::vector<double> rising_room(const ArmDescription& arm) {
  std::vector<double> room;
  for (int i = 0; i < arm.point_count(); ++i) {
    room.push_back(0.002 * i);
  }
  return room;
}

/// Points along the arcs, each as thick as its gap: brute force, gap by gap.
double sampled_clearance(const ArmDescription& arm, const Backbone& b,
                         const std::vector<Obstacle>& obstacles, const std::vector<double>& room,
                         int samples) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index gap = 0; gap + 1 < b.rows(); ++gap) {
    // Everything but this gap is folded into its first plate, so the oracle sees this gap alone.
    Backbone alone = b;
    for (Eigen::Index i = 0; i < b.rows(); ++i) {
      alone.row(i) = i <= gap ? b.row(gap) : b.row(gap + 1);
    }
    ArmDescription thin = arm;
    const auto g = static_cast<std::size_t>(gap);
    int passed = 0;
    double width = 0.0;
    for (const Segment& segment : arm.segments) {
      passed += segment.gaps;
      if (gap < passed) {
        width = segment.width_m;
        break;
      }
    }
    for (Segment& segment : thin.segments) {
      segment.width_m = width;
    }
    smallest = std::min(smallest, oracle::clearance(thin, alone, obstacles, samples) -
                                      std::max(room[g], room[g + 1]));
  }
  return smallest;
}

// Each gap is thicker by the larger room of its two plates.
TEST(CollisionRoom, AgreesWithDenseSamplingOfEveryGap) {
  constexpr int kSamples = 15;
  constexpr double kSpacingM = 0.235 / 5 / (kSamples - 1);
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  const std::vector<double> room = rising_room(arm);
  RandomStream random(9, 0);
  int touching = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Backbone b = no_load_backbone(model, random_pressures(arm, random));
    const std::vector<Obstacle> obstacles{random_obstacle(random), random_obstacle(random)};
    const CollisionChecker checker(arm, obstacles, 0.0, {room});
    const double sampled = sampled_clearance(arm, b, obstacles, room, kSamples);
    const double found = checker.clearance(b).value_m;
    EXPECT_LE(found, sampled + kFloatM) << trial;
    EXPECT_GE(found, sampled - kSpacingM / 2 - CollisionChecker::kToleranceM) << trial;
    if (sampled < 0.0) {
      EXPECT_FALSE(checker.is_free(b)) << trial;
      EXPECT_FALSE(checker.is_motion_free(b, b)) << trial;
      ++touching;
    } else if (sampled > kSpacingM / 2 + CollisionChecker::kToleranceM) {
      EXPECT_TRUE(checker.is_free(b)) << trial;
      EXPECT_TRUE(checker.is_motion_free(b, b)) << trial;
    }
  }
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 55);
}

TEST(CollisionRoom, OfNoPlateOrOfNothingChangesNoBit) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(10, 0);
  const std::vector<double> none(static_cast<std::size_t>(arm.point_count()), 0.0);
  const std::vector<double> even(static_cast<std::size_t>(arm.point_count()), 0.0125);
  for (int trial = 0; trial < 20; ++trial) {
    const Backbone b = no_load_backbone(model, random_pressures(arm, random));
    const std::vector<Obstacle> obstacles{random_obstacle(random)};
    EXPECT_EQ(CollisionChecker(arm, obstacles, 0.01, {none}).clearance(b).value_m,
              CollisionChecker(arm, obstacles, 0.01).clearance(b).value_m);
    EXPECT_NEAR(CollisionChecker(arm, obstacles, 0.0, {even}).clearance(b).value_m,
                CollisionChecker(arm, obstacles, 0.0125).clearance(b).value_m, 1e-12);
  }
}

constexpr RoomGrowth kGrowth{0.3, 0.2};

/// The room as it is in one shape, by the words of docs/tube.md (4).
std::vector<double> room_in(const Backbone& b, const Backbone& start,
                            const std::vector<double>& full_m) {
  std::vector<double> room = full_m;
  for (std::size_t i = 0; i < room.size(); ++i) {
    const auto plate = static_cast<Eigen::Index>(i);
    const double dx = double(b(plate, 0)) - double(start(plate, 0));
    const double dy = double(b(plate, 1)) - double(start(plate, 1));
    const double moved_m = std::sqrt(dx * dx + dy * dy);
    room[i] *= moved_m >= 0.2 ? 1.0 : 0.3 + 0.7 * moved_m / 0.2;
  }
  return room;
}

TEST(CollisionRoom, GrowsWithTheDistanceFromTheStart) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  const std::vector<double> full_m = rising_room(arm);
  RandomStream random(11, 0);
  for (int trial = 0; trial < 40; ++trial) {
    const Backbone start = no_load_backbone(model, random_pressures(arm, random));
    const Backbone b = no_load_backbone(model, random_pressures(arm, random));
    const std::vector<Obstacle> obstacles{random_obstacle(random), random_obstacle(random)};
    const CollisionChecker growing(arm, obstacles, 0.0, {full_m, kGrowth, start});
    const CollisionChecker there(arm, obstacles, 0.0, {room_in(b, start, full_m)});
    EXPECT_NEAR(growing.clearance(b).value_m, there.clearance(b).value_m, kFloatM) << trial;
    EXPECT_EQ(growing.is_free(b), there.is_free(b)) << trial;
  }
}

// At no moment of a motion that is called free does an obstacle lie in the room of that moment.
TEST(CollisionRoom, OfAMotionCoversThatOfEveryMoment) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  const std::vector<double> full_m = rising_room(arm);
  RandomStream random(12, 0);
  int free = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Backbone start = no_load_backbone(model, random_pressures(arm, random));
    const Backbone from = no_load_backbone(model, random_pressures(arm, random));
    const Backbone to =
        from + 0.2F * (no_load_backbone(model, random_pressures(arm, random)) - from);
    const std::vector<Obstacle> obstacles{random_obstacle(random)};
    const CollisionChecker growing(arm, obstacles, 0.0, {full_m, kGrowth, start});
    const double least_m = growing.motion_clearance(from, to).value_m;
    const bool is_free = growing.is_motion_free(from, to);
    free += is_free ? 1 : 0;
    for (int k = 0; k <= 10; ++k) {
      const Backbone b = from + 0.1F * static_cast<float>(k) * (to - from);
      const CollisionChecker then(arm, obstacles, 0.0, {room_in(b, start, full_m)});
      EXPECT_LE(least_m, then.clearance(b).value_m + CollisionChecker::kToleranceM) << trial;
      EXPECT_TRUE(!is_free || then.clearance(b).value_m > -kFloatM) << trial;
    }
  }
  EXPECT_GT(free, 10);
  EXPECT_LT(free, 55);
}

TEST(CollisionRoom, RefusesSizesAndNumbersThatAreNone) {
  const ArmDescription arm = three_segment_arm();
  EXPECT_THAT(
      [&] {
        CollisionChecker(arm, {}, 0.0, {{0.01, 0.02}});
      },
      ThrowsMessage<InputError>(HasSubstr("2 numbers of room; the arm has 16 plates")));
  std::vector<double> negative = rising_room(arm);
  negative[3] = -0.001;
  EXPECT_THAT([&] { CollisionChecker(arm, {}, 0.0, {negative}); },
              ThrowsMessage<InputError>(HasSubstr("room of -0.001 m at a plate")));
  EXPECT_THAT(
      [&] {
        CollisionChecker(arm, {}, 0.0, {rising_room(arm), {0.4, 0.1}, Backbone::Zero(3, 3)});
      },
      ThrowsMessage<InputError>(HasSubstr("grows from a start of 3 plates; the arm has 16")));
}

}  // namespace
}  // namespace limber
