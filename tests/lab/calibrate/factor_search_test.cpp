#include "src/lab/calibrate/binomial_bound.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace limber {
namespace {

struct Found {
  std::optional<std::size_t> factor;
  std::vector<std::size_t> tested;
};

/// Of ten factors the first `holding` hold.
Found search_from(std::size_t start, std::size_t holding) {
  Found found;
  found.factor = narrowest_factor(start, 10, 3, [&](std::size_t k) {
    found.tested.push_back(k);
    return k < holding;
  });
  return found;
}

using Tests = std::vector<std::size_t>;

TEST(NarrowestFactor, GoesOnUntilOneIsRefused) {
  const Found found = search_from(4, 7);
  EXPECT_EQ(found.factor, 6U);
  EXPECT_EQ(found.tested, Tests({4, 5, 6, 7}));
}

TEST(NarrowestFactor, EndsWithTheList) {
  const Found found = search_from(8, 10);
  EXPECT_EQ(found.factor, 9U);
  EXPECT_EQ(found.tested, Tests({8, 9}));
}

TEST(NarrowestFactor, WidensByTwoAfterARefusalAndTriesTheOneBetween) {
  const Found between_holds = search_from(6, 6);
  EXPECT_EQ(between_holds.factor, 5U);
  EXPECT_EQ(between_holds.tested, Tests({6, 4, 5}));
  const Found between_refused = search_from(6, 5);
  EXPECT_EQ(between_refused.factor, 4U);
  EXPECT_EQ(between_refused.tested, Tests({6, 4, 5}));
}

TEST(NarrowestFactor, MakesThreeTestsAtMostAfterARefusal) {
  EXPECT_EQ(search_from(6, 4).factor, 2U);
  EXPECT_EQ(search_from(6, 4).tested, Tests({6, 4, 2}));
  EXPECT_EQ(search_from(9, 2).factor, std::nullopt);
  EXPECT_EQ(search_from(9, 2).tested, Tests({9, 7, 5}));
}

TEST(NarrowestFactor, TestsNoFactorTwiceAtTheWidest) {
  EXPECT_EQ(search_from(1, 1).factor, 0U);
  EXPECT_EQ(search_from(1, 1).tested, Tests({1, 0}));
  EXPECT_EQ(search_from(1, 0).factor, std::nullopt);
  EXPECT_EQ(search_from(1, 0).tested, Tests({1, 0}));
}

}  // namespace
}  // namespace limber
