#include "limber/network/learnt_region.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/common/random_stream.hpp"
#include "network/sample_region.hpp"
#include "support/allocation_count.hpp"

namespace limber {
namespace {

constexpr double kDoubleRounding = 1e-6;  // parameters are floats
constexpr double kFloatRounding = 2e-5;   // sums of 50 products, in half ranges

struct State {
  Pressures kpa;
  Backbone backbone;
};

/// An arm of gaps about 4.7 cm long, its headings far from small.
State random_state(RandomStream& random, int segments, int points) {
  State state{Pressures(segments), Backbone::Zero(points, 3)};
  for (int i = 0; i < segments; ++i) {
    state.kpa[i] = static_cast<float>(random.uniform(-150.0, 150.0));
  }
  for (int j = 1; j < points; ++j) {
    const float heading = state.backbone(j - 1, 2);
    const auto length = static_cast<float>(random.uniform(0.04, 0.055));
    state.backbone.row(j) << state.backbone(j - 1, 0) + length * std::cos(heading),
        state.backbone(j - 1, 1) + length * std::sin(heading),
        heading + static_cast<float>(random.uniform(-0.3, 0.3));
  }
  return state;
}

/// Pressures, then each plate's pose about the plate before it, number by number.
std::vector<double> joint_by_hand(const State& state) {
  std::vector<double> z(state.kpa.begin(), state.kpa.end());
  for (Eigen::Index j = 1; j < state.backbone.rows(); ++j) {
    const double angle = state.backbone(j - 1, 2);
    const double dx = double(state.backbone(j, 0)) - double(state.backbone(j - 1, 0));
    const double dy = double(state.backbone(j, 1)) - double(state.backbone(j - 1, 1));
    z.push_back(dx * std::cos(angle) + dy * std::sin(angle));
    z.push_back(dy * std::cos(angle) - dx * std::sin(angle));
    z.push_back(double(state.backbone(j, 2)) - angle);
  }
  return z;
}

/// By the definition in the header, number by number.
double novelty_by_hand(const LearntRegion& region, const State& state) {
  const std::vector<double> z = joint_by_hand(state);
  double worst = 0.0;
  for (Eigen::Index i = 0; i < state.kpa.size(); ++i) {
    const double half = 0.5 * (double(region.high_kpa[i]) - double(region.low_kpa[i]));
    const double middle = 0.5 * (double(region.high_kpa[i]) + double(region.low_kpa[i]));
    worst = std::max(worst, std::abs(state.kpa[i] - middle) / (half * (1.0 + kPressureSlack)));
  }
  for (Eigen::Index k = 0; k < region.axes.rows(); ++k) {
    double along = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      along += double(region.axes(k, at)) * (z[i] - double(region.joint_offset[at])) *
               double(region.joint_scale[at]);
    }
    const double half = 0.5 * (double(region.axis_high[k]) - double(region.axis_low[k]));
    worst = std::max(
        worst,
        std::abs(along - 0.5 * (double(region.axis_high[k]) + double(region.axis_low[k]))) / half);
  }
  return worst;
}

/// Of a frame that follows `before`.
double novelty_by_hand(const LearntRegion& region, const State& state, const State& before) {
  const std::vector<double> now = joint_by_hand(state);
  const std::vector<double> then = joint_by_hand(before);
  double worst = novelty_by_hand(region, state);
  for (std::size_t i = 0; i < now.size(); ++i) {
    worst = std::max(worst, std::abs(now[i] - then[i]) / region.joint_change[Eigen::Index(i)]);
  }
  return worst;
}

TEST(LearntRegion, NoveltyIsThatOfItsDefinition) {
  RandomStream random(1, 0);
  for (const auto& [segments, points] : {std::pair{3, 16}, {1, 4}, {2, 7}}) {
    const LearntRegion region = sample_region(segments, points, 7);
    for (int trial = 0; trial < 100; ++trial) {
      const State state = random_state(random, segments, points);
      const double expected = novelty_by_hand(region, state);
      EXPECT_NEAR(region.novelty(state.kpa, state.backbone), expected, kDoubleRounding * expected);
      const State before = random_state(random, segments, points);
      const double following = novelty_by_hand(region, state, before);
      EXPECT_NEAR(region.novelty(state.kpa, state.backbone, before.kpa, before.backbone), following,
                  kDoubleRounding * following);
    }
  }
}

TEST(NoveltyMeasure, IsTheRegionsOnEveryCpuLevel) {
  RandomStream random(2, 0);
  for (const CpuLevel level : available_cpu_levels()) {
    for (const auto& [segments, points] : {std::pair{3, 16}, {1, 4}, {2, 7}}) {
      const LearntRegion region = sample_region(segments, points, 7);
      const NoveltyMeasure measure(region, level);
      NoveltyMeasure::Workspace workspace = measure.make_workspace();
      for (int trial = 0; trial < 100; ++trial) {
        const State state = random_state(random, segments, points);
        const double expected = region.novelty(state.kpa, state.backbone);
        EXPECT_NEAR(measure.novelty(state.kpa.data(), state.backbone.data(), workspace), expected,
                    kFloatRounding * (10.0 + expected));
        const State before = random_state(random, segments, points);
        const double following =
            region.novelty(state.kpa, state.backbone, before.kpa, before.backbone);
        EXPECT_NEAR(measure.novelty(state.kpa.data(), state.backbone.data(), before.kpa.data(),
                                    before.backbone.data(), workspace),
                    following, kFloatRounding * (10.0 + following));
      }
    }
  }
}

TEST(NoveltyMeasure, AllocatesNothing) {
  if (!kCountsAllocations) {
    GTEST_SKIP() << "the heap belongs to the sanitizer";
  }
  RandomStream random(3, 0);
  const NoveltyMeasure measure(sample_region(3, 16, 7));
  NoveltyMeasure::Workspace workspace = measure.make_workspace();
  const State state = random_state(random, 3, 16);
  const long before = allocations;
  EXPECT_GT(measure.novelty(state.kpa.data(), state.backbone.data(), state.kpa.data(),
                            state.backbone.data(), workspace),
            0.0F);
  EXPECT_EQ(allocations, before);
}

// The border, and linear growth beyond it: one segment, no axis that minds.
TEST(LearntRegion, IsOneOnTheBorderAndGrowsLinearly) {
  LearntRegion region = sample_region(1, 2, 1);
  region.axis_low.setConstant(-1e6F);
  region.axis_high.setConstant(1e6F);
  region.low_kpa << -20.0F;
  region.high_kpa << 60.0F;
  const Backbone straight = (Backbone(2, 3) << 0, 0, 0, 0.05F, 0, 0).finished();
  const auto at = [&](double kpa) {
    return region.novelty(Pressures::Constant(1, static_cast<float>(kpa)), straight);
  };
  const double half = 40.0 * (1.0 + kPressureSlack);
  EXPECT_NEAR(at(20.0 + half), 1.0, kDoubleRounding);
  EXPECT_NEAR(at(20.0 - half), 1.0, kDoubleRounding);
  EXPECT_NEAR(at(20.0 + 3.0 * half), 3.0, 3.0 * kDoubleRounding);
  EXPECT_LT(at(60.0), 1.0);
  EXPECT_LE(at(-20.0), 1.0);
  EXPECT_GT(at(61.0), 1.0);
}

TEST(LearntRegion, NoSpeedIsNovelToOneThatKnowsNone) {
  RandomStream random(8, 0);
  LearntRegion region = sample_region(3, 16, 7);
  const State now = random_state(random, 3, 16);
  const State before = random_state(random, 3, 16);
  const double standing = region.novelty(now.kpa, now.backbone);
  EXPECT_GT(region.novelty(now.kpa, now.backbone, before.kpa, before.backbone), standing);
  region.joint_change.resize(0);
  EXPECT_EQ(region.novelty(now.kpa, now.backbone, before.kpa, before.backbone), standing);
  const NoveltyMeasure measure(region);
  NoveltyMeasure::Workspace workspace = measure.make_workspace();
  EXPECT_NEAR(measure.novelty(now.kpa.data(), now.backbone.data(), before.kpa.data(),
                              before.backbone.data(), workspace),
              standing, kFloatRounding * (10.0 + standing));
}

// Gap poses don't know where the arm is: turned and shifted as a whole, it is as novel.
TEST(LearntRegion, DoesNotMindWhereTheBaseIs) {
  constexpr double kMovedRounding = 1e-3;  // floats of a moved arm, scaled by up to 1/mm
  RandomStream random(6, 0);
  const LearntRegion region = sample_region(3, 16, 7);
  const State state = random_state(random, 3, 16);
  Backbone moved = state.backbone;
  constexpr float kTurn_rad = 0.7F;
  moved.col(0) = std::cos(kTurn_rad) * state.backbone.col(0) -
                 std::sin(kTurn_rad) * state.backbone.col(1) + Eigen::VectorXf::Constant(16, 0.2F);
  moved.col(1) =
      std::sin(kTurn_rad) * state.backbone.col(0) + std::cos(kTurn_rad) * state.backbone.col(1);
  moved.col(2).array() += kTurn_rad;
  const double before = region.novelty(state.kpa, state.backbone);
  EXPECT_NEAR(region.novelty(state.kpa, moved), before, kMovedRounding * before);
}

TEST(LearntRegion, SaysItsRangesInOneLineForEachSegment) {
  LearntRegion region = sample_region(1, 2, 1);
  region.low_kpa << -98.2F;
  region.high_kpa << 97.5F;
  region.steepest_fall_kpa_per_s << 120.0F;
  region.steepest_rise_kpa_per_s << 115.0F;
  EXPECT_EQ(
      learnt_region_lines(region, Command{}),
      std::vector<std::string>{"segment 0: pressures -98.2 … 97.5 kPa, rates -120 … 115 kPa/s"});
}

}  // namespace
}  // namespace limber
