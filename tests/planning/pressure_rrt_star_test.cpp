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

TEST(PressureRrtStar, RewiresOnlyWhereTheBackboneMatches) {
  Setting s(true);
  PressureRrtStarSettings strict;
  strict.match_position_m = 0.0;
  PlannerLimits limits;
  limits.iterations = 500;
  const PlanResult exact = make_pressure_rrt_star(ParentRule::lazy, strict)
                               ->plan({s.arm, s.model, s.environment}, limits, 5);
  PressureRrtStarSettings loose;
  loose.match_position_m = 0.05;
  const PlanResult anything = make_pressure_rrt_star(ParentRule::lazy, loose)
                                  ->plan({s.arm, s.model, s.environment}, limits, 5);
  EXPECT_LT(exact.statistics.rewires_accepted, anything.statistics.rewires_accepted);
}

}  // namespace
}  // namespace limber
