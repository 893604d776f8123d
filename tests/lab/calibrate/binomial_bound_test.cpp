#include <cmath>

#include <gtest/gtest.h>

#include "src/lab/calibrate/binomial_bound.hpp"

namespace limber {
namespace {

constexpr double kExact = 1e-12;
constexpr double kTable = 5e-5;  // tables have four digits

TEST(BinomialAtMost, IsTheSumOfItsTerms) {
  EXPECT_NEAR(binomial_at_most(0, 10, 0.5), std::pow(0.5, 10), kExact);
  EXPECT_NEAR(binomial_at_most(1, 10, 0.5), 11.0 * std::pow(0.5, 10), kExact);
  EXPECT_NEAR(binomial_at_most(3, 4, 0.25), 1.0 - std::pow(0.25, 4), kExact);
  EXPECT_EQ(binomial_at_most(4, 4, 0.3), 1.0);
  EXPECT_EQ(binomial_at_most(0, 4, 0.0), 1.0);
  EXPECT_EQ(binomial_at_most(0, 4, 1.0), 0.0);
}

// Sides of two-sided 95 % intervals, as R's binom.test gives them.
TEST(ShareAtMost, IsTheTabledClopperPearsonBound) {
  EXPECT_NEAR(share_at_most(0, 10, 0.975), 0.3085, kTable);
  EXPECT_NEAR(share_at_most(2, 10, 0.975), 0.5561, kTable);
  EXPECT_NEAR(share_at_least(2, 10, 0.975), 0.0252, kTable);
  EXPECT_NEAR(share_at_most(5, 100, 0.975), 0.1128, kTable);
  EXPECT_NEAR(share_at_least(5, 100, 0.975), 0.0164, kTable);
}

// The rule of three's exact form: 1 − (1 − confidence)^(1/n).
TEST(ShareAtMost, HasAClosedFormWhereNothingIsOutside) {
  for (const int runs : {1, 12, 59, 4000}) {
    EXPECT_NEAR(share_at_most(0, runs, 0.95), 1.0 - std::pow(0.05, 1.0 / runs), kExact);
  }
  EXPECT_EQ(share_at_most(7, 7, 0.95), 1.0);
  EXPECT_EQ(share_at_least(0, 7, 0.95), 0.0);
}

TEST(ShareAtMost, LeavesItsConfidenceToTheTail) {
  for (const int outside : {1, 17, 170, 2000}) {
    const double share = share_at_most(outside, 4000, 0.95);
    EXPECT_NEAR(binomial_at_most(outside, 4000, share), 0.05, 1e-9);
  }
}

TEST(MinRuns, AreThoseOfTheToleranceTables) {
  EXPECT_EQ(min_runs(0.95, 0.95), 59);
  EXPECT_EQ(min_runs(0.90, 0.95), 29);
  EXPECT_EQ(min_runs(0.99, 0.95), 299);
  EXPECT_EQ(min_runs(0.5, 0.75), 2);
}

// 10 of 400 may be outside of a level of 0.95, not 11.
TEST(ShareThatPasses, LeavesTheTestItsProbability) {
  constexpr double kConfidence = 1.0 - 0.05 / 3.0;
  EXPECT_LE(share_at_most(10, 400, kConfidence), 0.05);
  EXPECT_GT(share_at_most(11, 400, kConfidence), 0.05);
  const double share = share_that_passes(400, 0.95, kConfidence, 0.8);
  EXPECT_NEAR(binomial_at_most(10, 400, share), 0.8, 1e-9);
  EXPECT_GT(share_that_passes(4000, 0.95, kConfidence, 0.8), share);
  EXPECT_NEAR(share_that_passes(min_runs(0.95, kConfidence), 0.95, kConfidence, 0.8),
              1.0 - std::pow(0.8, 1.0 / min_runs(0.95, kConfidence)), 1e-9);
}

}  // namespace
}  // namespace limber
