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

TEST(NarrowestFactor, WidensAfterARefusalAndNeverNarrowsAgain) {
  const Found found = search_from(6, 5);
  EXPECT_EQ(found.factor, 4U);
  EXPECT_EQ(found.tested, Tests({6, 5, 4}));
}

TEST(NarrowestFactor, GivesUpAfterThreeRefusalsOrTheWidest) {
  EXPECT_EQ(search_from(9, 2).factor, std::nullopt);
  EXPECT_EQ(search_from(9, 2).tested, Tests({9, 8, 7}));
  EXPECT_EQ(search_from(1, 0).factor, std::nullopt);
  EXPECT_EQ(search_from(1, 0).tested, Tests({1, 0}));
}

}  // namespace
}  // namespace limber
