#include "kernels/gap_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kStep = 1e-6;
constexpr double kTolerance = 1e-6;  // of central differences in double
constexpr int kGaps = 500;

using Gap = std::array<double, 3>;  // x, y, turn

class GapBoundTest : public ::testing::Test {
 protected:
  /// Steps of 2 to 8 cm in all directions: most violate a bound.
  Gap sampled_gap() {
    const double length_m = random_.uniform(0.02, 0.08);
    const double direction = random_.uniform(-M_PI, M_PI);
    return {length_m * std::cos(direction), length_m * std::sin(direction),
            random_.uniform(-0.4, 0.4)};
  }
  Gap sampled_gradient() { return {random_.normal(), random_.normal(), random_.normal()}; }

  Gap bounded(Gap gap) const {
    bound_gap(bound_, gap[0], gap[1], gap[2]);
    return gap;
  }
  Gap back(bool lead_back, const Gap& gap, Gap by) const {
    bound_gap_back(bound_, lead_back, gap[0], gap[1], gap[2], by[0], by[1], by[2]);
    return by;
  }
  /// Metres, and rad, beyond the bounds.
  Gap beyond(const Gap& gap) const {
    const double length_m = std::hypot(gap[0], gap[1]);
    return {std::max({0.0, bound_.min_length - length_m, length_m - bound_.max_length}), 0.0,
            std::max({0.0, bound_.min_turn - gap[2], gap[2] - bound_.max_turn})};
  }

  const GapBound<double> bound_ = gap_bound(0.045, 0.055, -0.2, 0.15);
  RandomStream random_{7, 0};
};

TEST_F(GapBoundTest, AgreesWithFiniteDifferences) {
  for (int k = 0; k < kGaps; ++k) {
    const Gap gap = sampled_gap();
    const Gap by = sampled_gradient();
    const Gap found = back(false, gap, by);
    for (std::size_t i = 0; i < gap.size(); ++i) {
      Gap above = gap;
      Gap below = gap;
      above[i] += kStep;
      below[i] -= kStep;
      double expected = 0.0;
      for (std::size_t j = 0; j < gap.size(); ++j) {
        expected += by[j] * (bounded(above)[j] - bounded(below)[j]) / (2.0 * kStep);
      }
      EXPECT_NEAR(found[i], expected, kTolerance) << "gap " << k << ", number " << i;
    }
  }
}

TEST_F(GapBoundTest, ADescentComesBackWithinTheBoundsAndNeverGoesFartherOut) {
  constexpr double kDescent = 1e-7;
  constexpr double kClearly = 0.01;  // gradients along the bound smaller than that are left out
  int led_back = 0;
  for (int k = 0; k < kGaps; ++k) {
    const Gap gap = sampled_gap();
    const Gap by = sampled_gradient();
    const Gap found = back(true, gap, by);
    Gap after = gap;
    for (std::size_t i = 0; i < gap.size(); ++i) {
      after[i] -= kDescent * found[i];
    }
    const double length_m = std::hypot(gap[0], gap[1]);
    const double by_length = (gap[0] * by[0] + gap[1] * by[1]) / length_m;
    const bool is_short = length_m < bound_.min_length;
    const bool is_low = gap[2] < bound_.min_turn;
    const Gap by_beyond = {is_short ? -by_length : by_length, 0.0, is_low ? -by[2] : by[2]};
    for (const std::size_t i : {0U, 2U}) {
      if (beyond(gap)[i] < 1e-4 || std::abs(by_beyond[i]) < kClearly) {
        continue;
      }
      const double expected = std::max(by_beyond[i], 0.0);
      EXPECT_NEAR((beyond(gap)[i] - beyond(after)[i]) / kDescent, expected, 1e-3) << "gap " << k;
      led_back += expected > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(led_back, kGaps / 10);
}

TEST_F(GapBoundTest, LeavesGapsWithinTheirBoundsAlone) {
  const Gap gap = {0.04, 0.03, 0.1};
  const Gap by = {1.0, -2.0, 3.0};
  EXPECT_EQ(bounded(gap), gap);
  EXPECT_EQ(back(true, gap, by), by);
  EXPECT_EQ(back(false, gap, by), by);
}

}  // namespace
}  // namespace limber
