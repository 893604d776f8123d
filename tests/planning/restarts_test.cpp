#include "src/planning/planner_budget.hpp"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>

namespace limber {
namespace {

using ::testing::ElementsAre;

TEST(Restarts, LengthsAreLubysSequence) {
  std::vector<double> lengths;
  for (std::uint64_t i = 1; i <= 15; ++i) {
    lengths.push_back(Restarts::length(i));
  }
  EXPECT_THAT(lengths, ElementsAre(1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8));
}

// Half of all terms are 1, a quarter 2, and so on: every length has the same share of the time.
TEST(Restarts, EveryLengthGetsTheSameTime) {
  std::vector<double> time(5);
  for (std::uint64_t i = 1; i < 32; ++i) {
    const double length = Restarts::length(i);
    time[static_cast<std::size_t>(std::log2(length))] += length;
  }
  EXPECT_THAT(time, ::testing::Each(16.0));
}

TEST(Restarts, IsDueAfterTheLengthOfEachSearchAndCountsThem) {
  Restarts restarts(100.0);
  EXPECT_FALSE(restarts.is_due(99));
  EXPECT_TRUE(restarts.is_due(100));
  restarts.begin(130);
  EXPECT_FALSE(restarts.is_due(229));
  EXPECT_TRUE(restarts.is_due(230));
  restarts.begin(230);
  EXPECT_FALSE(restarts.is_due(429)) << "the third search is twice as long";
  EXPECT_TRUE(restarts.is_due(430));
}

}  // namespace
}  // namespace limber
