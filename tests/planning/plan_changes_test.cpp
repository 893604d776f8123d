#include "src/planning/search/plan_improver.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "limber/world/straight_motion.hpp"
#include "planning/random_shapes.hpp"

namespace limber {
namespace {

constexpr double kRoundingKpa = 1e-3;  // of a cost that float32 pressures make

class PlanChanges : public ::testing::Test {
 protected:
  Waypoints random_waypoints(RandomStream& random, std::size_t count) const {
    Waypoints waypoints{Pressures::Zero(3)};
    while (waypoints.size() < count) {
      waypoints.push_back(random_pressures(arm_, random));
    }
    return waypoints;
  }

  bool is_inside(const Waypoints& waypoints) const {
    return std::all_of(waypoints.begin(), waypoints.end(),
                       [&](const Pressures& kpa) { return space_.box.limited(kpa) == kpa; });
  }

  ArmDescription arm_ = three_segment_arm();
  ChangeSpace space_{pressure_limits_kpa(arm_), pressure_box(arm_)};
};

TEST_F(PlanChanges, LeavingOutKeepsTheEndsAndTheOrderAndNeverCosts) {
  RandomStream random(1, 1);
  for (int k = 0; k < 300; ++k) {
    const Waypoints before = random_waypoints(random, 3 + random.index(8));
    const Waypoints after = without_some(before, random);
    ASSERT_GE(before.size(), after.size() + 1);
    const std::size_t gone = before.size() - after.size();
    EXPECT_LE(gone, 4U);
    // A run of them: the rest are a head and a tail of what there was.
    std::size_t head = 0;
    while (head < after.size() && after[head] == before[head]) {
      ++head;
    }
    EXPECT_GE(head, 1U);
    EXPECT_LT(head, after.size()) << "the end stays";
    EXPECT_TRUE(std::equal(after.begin() + std::ptrdiff_t(head), after.end(),
                           before.begin() + std::ptrdiff_t(head + gone)));
    EXPECT_LE(path_cost_kpa(after), path_cost_kpa(before) + kRoundingKpa);
  }
}

TEST_F(PlanChanges, EveryRunOfWaypointsIsLeftOutSometimes) {
  RandomStream random(2, 1);
  const Waypoints before = random_waypoints(random, 5);
  std::set<std::vector<float>> kinds;
  for (int k = 0; k < 500; ++k) {
    std::vector<float> kind;
    for (const Pressures& kpa : without_some(before, random)) {
      kind.push_back(kpa[0]);
    }
    kinds.insert(kind);
  }
  EXPECT_EQ(kinds.size(), 6U) << "of three inner ones: three alone, two pairs, all";
}

TEST_F(PlanChanges, StraighteningPutsOneSegmentOnALineAndNeverCosts) {
  RandomStream random(3, 1);
  for (int k = 0; k < 300; ++k) {
    const Waypoints before = random_waypoints(random, 3 + random.index(8));
    const Waypoints after = straightened(before, random);
    ASSERT_EQ(after.size(), before.size());
    EXPECT_LE(path_cost_kpa(after), path_cost_kpa(before) + kRoundingKpa);
    std::set<Eigen::Index> changed_segments;
    std::size_t first = after.size(), last = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
      for (Eigen::Index segment = 0; segment < 3; ++segment) {
        if (after[i][segment] != before[i][segment]) {
          changed_segments.insert(segment);
          first = std::min(first, i);
          last = std::max(last, i);
        }
      }
    }
    ASSERT_EQ(changed_segments.size(), 1U);
    EXPECT_GT(first, 0U);
    EXPECT_LT(last + 1, after.size());
    const Eigen::Index segment = *changed_segments.begin();
    const float rise = after[first][segment] - after[first - 1][segment];
    for (std::size_t i = first; i <= last + 1; ++i) {
      EXPECT_NEAR(after[i][segment] - after[i - 1][segment], rise, kRoundingKpa);
    }
  }
}

TEST_F(PlanChanges, ASplitLiesOnTheLineSoItCostsNothing) {
  RandomStream random(4, 1);
  for (int k = 0; k < 300; ++k) {
    const Waypoints before = random_waypoints(random, 2 + random.index(8));
    const Waypoints after = split(before, space_, random);
    ASSERT_EQ(after.size(), before.size() + 1);
    EXPECT_NEAR(path_cost_kpa(after), path_cost_kpa(before), kRoundingKpa);
    std::size_t at = 0;
    while (at < before.size() && after[at] == before[at]) {
      ++at;
    }
    EXPECT_TRUE(std::equal(before.begin() + std::ptrdiff_t(at), before.end(),
                           after.begin() + std::ptrdiff_t(at + 1)));
    EXPECT_GT(at, 0U);
    EXPECT_LT(at, before.size());
  }
  const Waypoints full = random_waypoints(random, kMaxWaypoints);
  EXPECT_EQ(split(full, space_, random), full);
}

TEST_F(PlanChanges, ShiftingTheEndTakesAllAlongInProportion) {
  RandomStream random(5, 1);
  Waypoints before{Pressures::Zero(3)};
  for (int i = 1; i <= 4; ++i) {
    before.push_back(0.5F * random_pressures(arm_, random));
  }
  const Pressures shift = Eigen::Vector3f(8.0F, -4.0F, 20.0F);
  const Waypoints after = with_end_shifted(before, space_, shift);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_TRUE((after[i] - before[i]).isApprox(shift * (float(i) / 4.0F), 1e-4F)) << i;
  }
  const Waypoints far = with_end_shifted(before, space_, 1000.0F * shift);
  EXPECT_EQ(far.back(), Pressures(Eigen::Vector3f(100.0F, -100.0F, 100.0F)));
}

TEST_F(PlanChanges, HalfOfTheShiftsMoveOneSegmentAlone) {
  RandomStream random(6, 1);
  constexpr int kShifts = 4000;
  int alone = 0, small = 0;
  for (int k = 0; k < kShifts; ++k) {
    const Pressures shift = random_shift(space_, random);
    const auto moved = (shift.array() != 0.0F).count();
    ASSERT_TRUE(moved == 1 || moved == 3);
    alone += moved == 1 ? 1 : 0;
    small += shift.cwiseAbs().maxCoeff() < 2.0F ? 1 : 0;
  }
  constexpr int kFiveDeviations = 160;
  EXPECT_NEAR(alone, kShifts / 2, kFiveDeviations);
  EXPECT_GT(small, kShifts / 4) << "of all scales, 0.2 kPa to 30 kPa";
  EXPECT_LT(small, 3 * kShifts / 4);
}

TEST_F(PlanChanges, EveryChangeKeepsTheStartAndStaysInside) {
  RandomStream random(7, 1);
  space_.box.high_kpa[1] = 20.0F;  // as where recordings end there
  std::set<std::ptrdiff_t> growths;
  int same_count = 0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Waypoints before = random_waypoints(random, 2 + random.index(8));
    for (Pressures& kpa : before) {
      kpa = space_.box.limited(kpa);
    }
    RandomStream one(8, k);
    RandomStream same(8, k);
    const Waypoints after = changed(before, space_, one);
    EXPECT_EQ(after.front(), before.front());
    EXPECT_GE(after.size(), 2U);
    EXPECT_TRUE(is_inside(after));
    same_count += after == before ? 1 : 0;
    EXPECT_EQ(after, changed(before, space_, same)) << "the stream alone decides";
    growths.insert(std::ssize(after) - std::ssize(before));
  }
  EXPECT_LT(same_count, 30) << "of 1000: shifts against a limit that change nothing";
  EXPECT_EQ(*growths.begin(), -4);
  EXPECT_EQ(*growths.rbegin(), 1);
}

}  // namespace
}  // namespace limber
