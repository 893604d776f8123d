#include "src/planning/paper/rrt_star_search.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "limber/world/collision.hpp"
#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

/// Grows a tree and checks what must hold of every node after any number of rewirings.
void expect_sound_tree(const Setting& s, int iterations, std::uint64_t* accepted) {
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  MotionSimulator simulator(s.arm, s.model, checker);
  RrtStarSearch search(problem, simulator, PressureRrtStarSettings(), 5);
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
  const PlannerStatistics statistics = search.statistics();
  *accepted = statistics.rewires_accepted;
  EXPECT_GT(statistics.rewires_tried, statistics.rewires_accepted);
}

TEST(RrtStarSearch, EveryNodeIsWhatItsParentLeadsToAfterAnyRewiring) {
  std::uint64_t without_memory = 0;
  std::uint64_t with_memory = 0;
  expect_sound_tree(Setting(false), 600, &without_memory);
  expect_sound_tree(Setting(true), 1500, &with_memory);
  EXPECT_GT(without_memory, 20U);
  EXPECT_GT(with_memory, 0U) << "the test should hold rewirings that change shapes downstream";
}

/// Whether the node or one above it has another parent in `tree`.
bool is_rewired(const PressureTree& before, const PressureTree& tree, int node) {
  const std::vector<int> above = before.nodes_to(node);
  return std::any_of(above.begin(), above.end(),
                     [&](int i) { return before.parent(i) != tree.parent(i); });
}

// What was simulated below a node stands on its backbone.
TEST(RrtStarSearch, ARewiredNodeStaysWhereItWasWithinTheSettings) {
  const Setting s(true);
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, s.environment.obstacles);
  MotionSimulator simulator(s.arm, s.model, checker);
  PressureRrtStarSettings settings;
  settings.match_position_m = 0.003;
  settings.match_orientation_rad = 0.02;
  RrtStarSearch search(problem, simulator, settings, 5);
  PlannerLimits limits;
  limits.iterations = 1500;
  const PlannerBudget budget(limits, {});
  double farthest_m = 0.0;
  double most_turned_rad = 0.0;
  for (std::uint64_t k = 0; k < *limits.iterations; ++k) {
    const PressureTree before = search.tree();
    search.iterate(budget);
    const PressureTree& tree = search.tree();
    for (int i = 1; i < before.size(); ++i) {
      if (before.parent(i) == tree.parent(i) || is_rewired(before, tree, before.parent(i))) {
        continue;
      }
      EXPECT_EQ(before.setpoint_kpa(i), tree.setpoint_kpa(i));
      const Backbone apart = before.backbone(i) - tree.backbone(i);
      farthest_m = std::max<double>(farthest_m, apart.leftCols<2>().rowwise().norm().maxCoeff());
      most_turned_rad = std::max<double>(most_turned_rad, apart.col(2).cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LE(farthest_m, settings.match_position_m);
  EXPECT_LE(most_turned_rad, settings.match_orientation_rad);
  EXPECT_GT(farthest_m, 0.3 * settings.match_position_m) << "the test should hold such rewirings";
}

/// A search, and a budget that is never spent.
struct Grown {
  Grown(const Setting& s, int iterations)
      : problem{s.arm, s.model, s.environment},
        checker(s.arm, s.environment.obstacles),
        simulator(s.arm, s.model, checker),
        search(problem, simulator, PressureRrtStarSettings(), 5) {
    PlannerLimits limits;
    limits.iterations = 1;
    const PlannerBudget budget(limits, {});
    for (int k = 0; k < iterations; ++k) {
      const std::optional<double> before_kpa = search.best_cost_kpa();
      search.iterate(budget);
      EXPECT_TRUE(!before_kpa || *search.best_cost_kpa() <= *before_kpa);
    }
  }

  PlanningProblem problem;
  CollisionChecker checker;
  MotionSimulator simulator;
  RrtStarSearch search;
};

TEST(RrtStarSearch, ItsBestIsTheCheapestOfItsNodesThatEndInTheGoal) {
  const Setting s(true);
  const Grown grown(s, 1500);
  const PressureTree& tree = grown.search.tree();
  double best_kpa = std::numeric_limits<double>::infinity();
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tree.size(); ++i) {
    nearest = std::min(nearest, goal_error(s.environment.goal, tree.settled_tip(i)));
    if (ends_in_goal(grown.problem, walk(grown.problem, grown.checker, tree.path_to(i)))) {
      best_kpa = std::min(best_kpa, tree.cost_kpa(i));
    }
  }
  ASSERT_TRUE(grown.search.best_cost_kpa());
  constexpr double kImprovementKpa = 1e-5;
  EXPECT_NEAR(*grown.search.best_cost_kpa(), best_kpa, kImprovementKpa);
  EXPECT_NEAR(path_cost_kpa(grown.search.best_waypoints_kpa()), best_kpa, 1e-3);
  const Walk to_nearest = walk(grown.problem, grown.checker, grown.search.nearest_waypoints_kpa());
  EXPECT_TRUE(to_nearest.is_free);
  EXPECT_LE(goal_error(s.environment.goal,
                       grown.problem.model.settled_tip(to_nearest.states.back().valves,
                                                       to_nearest.states.back().backbone)),
            nearest + 1e-6);
}

}  // namespace
}  // namespace limber
