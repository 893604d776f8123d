#include "src/planning/paper/pressure_rrt_star.hpp"

#include <gtest/gtest.h>

#include "limber/world/collision.hpp"
#include "planning/planner_setting.hpp"
#include "src/planning/paper/rrt_star_search.hpp"

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

/// Grows a tree and checks what must hold of every node after any number of rewirings.
void expect_sound_tree(const Setting& s, int iterations, std::uint64_t* accepted) {
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  MotionSimulator simulator(s.arm, s.model, checker);
  RrtStarSearch search(problem, simulator, ParentRule::lazy, PressureRrtStarSettings(), 5);
  PlannerLimits limits;
  limits.iterations = static_cast<std::uint64_t>(iterations);
  const PlannerBudget budget(limits, {});
  for (int k = 0; k < iterations; ++k) {
    search.iterate(budget);
  }
  const PressureTree& tree = search.tree();
  MotionState end;
  for (int i = 1; i < tree.size(); ++i) {
    const int parent = tree.parent(i);
    constexpr double kSumKpa = 1e-9;
    EXPECT_NEAR(
        tree.cost_kpa(i),
        tree.cost_kpa(parent) + motion_cost_kpa(tree.setpoint_kpa(parent), tree.setpoint_kpa(i)),
        kSumKpa);
    ASSERT_TRUE(simulator.move(tree.state(parent), tree.setpoint_kpa(i), end));
    ASSERT_TRUE(end == tree.state(i)) << "node " << i;
  }
  PlannerStatistics statistics;
  search.fill(statistics);
  *accepted = statistics.rewires_accepted;
  EXPECT_GT(statistics.rewires_tried, statistics.rewires_accepted);
}

TEST(PressureRrtStar, EveryNodeIsWhatItsParentLeadsToAfterAnyRewiring) {
  std::uint64_t without_memory = 0;
  std::uint64_t with_memory = 0;
  expect_sound_tree(Setting(false), 600, &without_memory);
  expect_sound_tree(Setting(true), 1500, &with_memory);
  EXPECT_GT(without_memory, 20U);
  EXPECT_GT(with_memory, 0U) << "the test should hold rewirings that change shapes downstream";
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
