#include "src/planning/paper/pressure_rrt_star.hpp"

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

TEST(PressureRrtStar, LazyAndSteerAllGrowTheSameTree) {
  for (const bool play : {false, true}) {
    for (const std::uint64_t seed : {3, 4}) {
      Setting s(play);
      const PlanResult lazy = s.plan("paper", 400, seed);
      const PlanResult all = s.plan("paper-steer-all", 400, seed);
      EXPECT_GT(lazy.tree.size(), 100U);
      EXPECT_TRUE(same_tree(lazy, all)) << play << ' ' << seed;
      EXPECT_EQ(lazy.statistics.rewires_accepted, all.statistics.rewires_accepted);
      EXPECT_EQ(lazy.plan.has_value(), all.plan.has_value());
      EXPECT_LT(lazy.statistics.queries, all.statistics.queries / 2);
    }
  }
}

}  // namespace
}  // namespace limber
