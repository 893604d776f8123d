#include "limber/common/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;       // relative, of sums of some numbers
constexpr double kPrintedDigits = 1e-10;  // the script prints 12 digits of numbers below 10

std::vector<double> random_numbers(int count, RandomStream& random) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(random.uniform(-5.0, 9.0));
  }
  return values;
}

/// 0, 1, … count − 1, the largest first.
std::vector<double> falling(int count) {
  std::vector<double> values;
  for (int i = count - 1; i >= 0; --i) {
    values.push_back(i);
  }
  return values;
}

struct NumpyCase {
  std::vector<double> values;
  std::array<double, 7> says;  // mean, deviation, standard error, quantiles 5, 25, 50 and 95 %
};

// Printed by make_numpy_statistics.py (NumPy 1.24).
const std::vector<NumpyCase> kNumpyCases = {
    {{1.004}, {1.004, 0, 0, 1.004, 1.004, 1.004, 1.004}},
    {{1.896, 0.178}, {1.037, 0.859, 0.859, 0.2639, 0.6075, 1.037, 1.8101}},
    {{-1.672, -0.364, -1.975, 1.18, 5.021},
     {0.438, 2.54842406204, 1.27421203102, -1.9144, -1.672, -0.364, 4.2528}},
    {{-0.477, -0.861, 2.47,   2.071, 1.316,  -1.791, 0.912, 3.086, -3.033, -0.373,
      -4.704, -2.869, -4.525, 0.295, -2.802, 1.814,  1.47,  0.439, -6.55,  -0.616},
     {-0.7364, 2.57725426375, 0.591262678288, -4.7963, -2.81875, -0.425, 2.5008}}};

TEST(Statistics, AreNumPys) {
  for (const NumpyCase& one : kNumpyCases) {
    EXPECT_NEAR(mean(one.values), one.says[0], kPrintedDigits);
    EXPECT_NEAR(standard_deviation(one.values), one.says[1], kPrintedDigits);
    if (one.values.size() > 1) {
      EXPECT_NEAR(standard_error(one.values), one.says[2], kPrintedDigits);
    }
    EXPECT_NEAR(quantile(one.values, 0.05), one.says[3], kPrintedDigits);
    EXPECT_NEAR(quantile(one.values, 0.25), one.says[4], kPrintedDigits);
    EXPECT_NEAR(median(one.values), one.says[5], kPrintedDigits);
    EXPECT_NEAR(quantile(one.values, 0.95), one.says[6], kPrintedDigits);
  }
}

// Of 0 … n − 1 the quantile is share · (n − 1), the mean (n − 1)/2, the variance (n² − 1)/12.
TEST(Statistics, OfCountingNumbersAreClosedForms) {
  for (const int n : {2, 3, 10, 101}) {
    const std::vector<double> values = falling(n);
    EXPECT_DOUBLE_EQ(mean(values), 0.5 * (n - 1));
    EXPECT_NEAR(standard_deviation(values), std::sqrt((n * n - 1) / 12.0), kRounding * n);
    EXPECT_NEAR(standard_error(values), std::sqrt((n + 1) / 12.0), kRounding * n);
    for (const double share : {0.0, 0.1, 0.5, 0.95, 1.0}) {
      EXPECT_NEAR(quantile(values, share), share * (n - 1), kRounding * n);
    }
  }
}

TEST(Statistics, OfOneNumberAreThatNumber) {
  for (const double share : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(quantile({4.25}, share), 4.25);
  }
  EXPECT_EQ(mean(std::vector{4.25}), 4.25);
  EXPECT_EQ(standard_deviation(std::vector{4.25}), 0.0);
}

TEST(Statistics, TheMedianOfTwoIsHalfwayAndOfThreeTheMiddleOne) {
  EXPECT_EQ(median({5.0, 1.0}), 3.0);
  EXPECT_EQ(median({5.0, 1.0, 2.0}), 2.0);
}

TEST(Statistics, QuantilesDoNotDependOnTheOrder) {
  RandomStream random(3, 0);
  std::vector<double> values = random_numbers(40, random);
  const double before = quantile(values, 0.37);
  for (int k = 0; k < 20; ++k) {
    std::rotate(values.begin(), values.begin() + 1 + random.index(39), values.end());
    std::swap(values[random.index(40)], values[random.index(40)]);
    EXPECT_EQ(quantile(values, 0.37), before);
  }
}

TEST(Statistics, QuantilesRiseFromTheSmallestToTheLargest) {
  RandomStream random(4, 0);
  for (const int count : {1, 2, 7, 50}) {
    const std::vector<double> values = random_numbers(count, random);
    EXPECT_EQ(quantile(values, 0.0), std::ranges::min(values));
    EXPECT_EQ(quantile(values, 1.0), std::ranges::max(values));
    double before = quantile(values, 0.0);
    for (int k = 1; k <= 1000; ++k) {
      const double now = quantile(values, k / 1000.0);
      EXPECT_LE(before, now) << k << " of 1000, " << count << " numbers";
      before = now;
    }
  }
}

TEST(Statistics, QuantilesFollowShiftsAndScales) {
  RandomStream random(5, 0);
  const std::vector<double> values = random_numbers(33, random);
  std::vector<double> other;
  for (const double value : values) {
    other.push_back(2.0 - 3.0 * value);
  }
  EXPECT_NEAR(quantile(other, 0.05), 2.0 - 3.0 * quantile(values, 0.95), 100.0 * kRounding);
  EXPECT_NEAR(mean(other), 2.0 - 3.0 * mean(values), 100.0 * kRounding);
  EXPECT_NEAR(standard_deviation(other), 3.0 * standard_deviation(values), 100.0 * kRounding);
}

// What overflowed stays beyond the quantiles below it.
TEST(Statistics, AnInfiniteNumberIsTheLargest) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(quantile({0.0, kInfinity, 1.0}, 0.5), 1.0);
  EXPECT_EQ(quantile({0.0, kInfinity, 1.0}, 1.0), kInfinity);
}

}  // namespace
}  // namespace limber
