#include "src/plot/chart_measure.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

namespace limber {
namespace {

using ::testing::ElementsAre;

/// Share of a step by which doubles may miss a multiple of it.
constexpr double kRounding = 1e-6;

const std::vector<std::pair<double, double>> kRanges{
    {0.0, 1.0},     {-3.2, 7.7},   {0.017, 0.0191}, {-1e-7, 3e-7}, {1e6, 9.3e6},
    {99.98, 100.1}, {-250.0, -17}, {0.0, 1e-12},    {-1.0, 1.0},   {3.0, 3.0000001}};

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  for (const auto& [low, high] : kRanges) {
    for (const int count : {1, 3, 5, 10}) {
      const double step = nice_step(low, high, count);
      const double digit = step / std::pow(10.0, std::floor(std::log10(step * (1.0 + kRounding))));
      EXPECT_TRUE(std::abs(digit - 1.0) < kRounding || std::abs(digit - 2.0) < kRounding ||
                  std::abs(digit - 5.0) < kRounding)
          << low << " … " << high << ", " << count << ": " << step;
    }
  }
}

TEST(NiceRange, CoversTheDataAndEndsOnTicks) {
  for (const auto& [low, high] : kRanges) {
    const NiceRange range = nice_range(low, high);
    const double step = nice_step(low, high, 5);
    EXPECT_LE(range.low, low + kRounding * step);
    EXPECT_GE(range.high, high - kRounding * step);
    EXPECT_GT(range.low, low - step);
    EXPECT_LT(range.high, high + step);
    const AxisTicks ticks = linear_ticks(range.low, range.high);
    EXPECT_NEAR(ticks.values.front(), range.low, kRounding * step);
    EXPECT_NEAR(ticks.values.back(), range.high, kRounding * step);
  }
}

TEST(NiceRange, OpensAroundASingleValue) {
  for (const double value : {0.0, 5.0, -3.0, 1e9, 1e-9}) {
    const NiceRange range = nice_range(value, value);
    EXPECT_LT(range.low, value);
    EXPECT_GT(range.high, value);
  }
}

TEST(NiceRange, DoesNotMindTheOrder) {
  EXPECT_EQ(nice_range(7.0, 2.0).low, nice_range(2.0, 7.0).low);
  EXPECT_EQ(nice_range(7.0, 2.0).high, nice_range(2.0, 7.0).high);
}

TEST(LinearTicks, LieEvenlyInTheRangeAndHaveDistinctLabels) {
  for (const auto& [low, high] : kRanges) {
    const AxisTicks ticks = linear_ticks(low, high);
    ASSERT_GE(ticks.values.size(), 2U) << low << " … " << high;
    ASSERT_LE(ticks.values.size(), 11U) << low << " … " << high;
    ASSERT_EQ(ticks.values.size(), ticks.labels.size());
    const double step = nice_step(low, high, 5);
    for (std::size_t i = 0; i + 1 < ticks.values.size(); ++i) {
      EXPECT_NEAR(ticks.values[i + 1] - ticks.values[i], step, kRounding * step);
    }
    EXPECT_GE(ticks.values.front(), low - kRounding * step);
    EXPECT_LE(ticks.values.back(), high + kRounding * step);
  }
  EXPECT_THAT(linear_ticks(0.0, 1.0).labels, ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(linear_ticks(-50.0, 50.0).labels, ElementsAre("-40", "-20", "0", "20", "40"));
}

TEST(LogarithmicTicks, ArePowersOfTenWhereThereAreMany) {
  EXPECT_THAT(logarithmic_ticks(0.01, 1000.0).labels,
              ElementsAre("0.01", "0.1", "1", "10", "100", "1000"));
}

TEST(LogarithmicTicks, AddTwosAndFivesWhereThereAreFew) {
  EXPECT_THAT(logarithmic_ticks(0.5, 20.0).labels, ElementsAre("0.5", "1", "2", "5", "10", "20"));
}

TEST(NiceLogarithmicRange, CoversTheDataWithAtLeastTwoTicks) {
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{
           {0.3, 0.45}, {1.0, 1.0}, {0.001, 7.0}, {1e-12, 1e9}, {2.0, 5.0}}) {
    const NiceRange range = nice_logarithmic_range(low, high);
    EXPECT_LE(range.low, low * (1.0 + kRounding));
    EXPECT_GE(range.high, high * (1.0 - kRounding));
    EXPECT_GE(logarithmic_ticks(range.low, range.high).values.size(), 2U) << low << " … " << high;
  }
}

}  // namespace
}  // namespace limber
