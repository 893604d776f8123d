#include "src/plot/chart_shapes.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

TEST(Spread, OfZeroToHundredIsKnown) {
  std::vector<double> values(101);
  std::iota(values.rbegin(), values.rend(), 0.0);
  const Spread spread = spread_of(values);
  EXPECT_DOUBLE_EQ(spread.mean, 50.0);
  EXPECT_DOUBLE_EQ(spread.p05, 5.0);
  EXPECT_DOUBLE_EQ(spread.p25, 25.0);
  EXPECT_DOUBLE_EQ(spread.median, 50.0);
  EXPECT_DOUBLE_EQ(spread.p75, 75.0);
  EXPECT_DOUBLE_EQ(spread.p95, 95.0);
}

TEST(Spread, InterpolatesBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(spread_of({2.0, 1.0}).median, 1.5);
  EXPECT_DOUBLE_EQ(spread_of({4.0}).p95, 4.0);
}

// The sample quantiles of a normal distribution: its density is known in closed form.
TEST(DensityOutline, FollowsANormalDensity) {
  constexpr double kTolerance = 0.03;  // of the peak; bandwidth and bins widen it this much
  std::vector<double> values;
  constexpr int kHalf = 2000;
  for (int i = 1; i < kHalf; ++i) {
    // x whose normal distribution function is u, by Newton's method.
    const double u = 0.5 + 0.5 * i / kHalf;
    double x = 0.0;
    for (int step = 0; step < 60; ++step) {
      const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
      x -= (0.5 * std::erfc(-x / std::numbers::sqrt2) - u) / density;
    }
    values.push_back(x);
    values.push_back(-x);
  }
  const DensityOutline outline = density_outline(values, 61);
  for (std::size_t i = 0; i < outline.at.size(); ++i) {
    EXPECT_NEAR(outline.density[i], std::exp(-0.5 * outline.at[i] * outline.at[i]), kTolerance);
  }
}

TEST(DensityOutline, OfEqualValuesIsOneStep) {
  const DensityOutline outline = density_outline({3.0, 3.0, 3.0}, 50);
  EXPECT_THAT(outline.at, ::testing::ElementsAre(3.0));
  EXPECT_THAT(outline.density, ::testing::ElementsAre(1.0));
}

}  // namespace
}  // namespace limber
