#include "src/planning/search/batch_search.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

constexpr std::uint64_t kSeed = 3;
constexpr double kSumKpa = 1e-9;  // of costs added up in another order

const auto kNever = [] { return false; };

/// A search on an arm with play, which remembers how its pressures were reached.
struct Search {
  explicit Search(const Setting& s, int jobs = 1, std::uint64_t seed = kSeed,
                  const DefaultPlannerSettings& settings = {})
      : problem{s.arm, s.model, s.environment},
        checker(s.arm, s.environment.obstacles),
        simulator(problem, checker, {settings.hold_position_m, settings.hold_orientation_rad},
                  jobs),
        search(problem, simulator, settings, seed) {}

  std::vector<BatchSearch::Solution> rounds(int count,
                                            const std::optional<double>& best_kpa = std::nullopt) {
    std::vector<BatchSearch::Solution> found;
    for (int k = 0; k < count; ++k) {
      for (const BatchSearch::Solution& one : search.round(best_kpa, kNever)) {
        found.push_back(one);
      }
    }
    return found;
  }

  PlanningProblem problem;
  CollisionChecker checker;
  PathSimulator simulator;
  BatchSearch search;
};

TEST(BatchSearch, EveryNodeIsWhereItsFreeMotionLeadsAndCostsOfMotionsAddUp) {
  const Setting s(true);
  Search one(s);
  one.rounds(25);
  const PressureTree& tree = one.search.tree();
  ASSERT_GT(tree.size(), 200);
  EXPECT_TRUE(tree.state(0) == start_of(one.problem));
  EXPECT_EQ(tree.cost_kpa(0), 0.0);
  const Pressures limits = pressure_limits_kpa(s.arm);
  MotionSimulator simulator(s.arm, s.model, one.checker);
  MotionState end;
  for (int i = 1; i < tree.size(); ++i) {
    const int parent = tree.parent(i);
    ASSERT_LT(parent, i);
    EXPECT_NEAR(
        tree.cost_kpa(i),
        tree.cost_kpa(parent) + motion_cost_kpa(tree.setpoint_kpa(parent), tree.setpoint_kpa(i)),
        kSumKpa);
    EXPECT_NEAR(tree.cost_kpa(i), path_cost_kpa(tree.path_to(i)), 1e-6 * tree.cost_kpa(i));
    EXPECT_LE((tree.setpoint_kpa(i).cwiseAbs() - limits).maxCoeff(), 0.0F);
    ASSERT_TRUE(simulator.move(tree.state(parent), tree.setpoint_kpa(i), end)) << "node " << i;
    ASSERT_TRUE(end == tree.state(i)) << "node " << i;
  }
}

TEST(BatchSearch, SolutionsAreNodesThatEndInTheGoalAfterTheHold) {
  const Setting s(true);
  Search one(s);
  const std::vector<BatchSearch::Solution> found = one.rounds(60);
  ASSERT_GT(found.size(), 5U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].cost_kpa, one.search.tree().cost_kpa(found[k].node));
    const Walk alone = walk(one.problem, one.checker, one.search.waypoints_to(found[k].node));
    EXPECT_TRUE(ends_in_goal(one.problem, alone)) << "solution " << k;
    EXPECT_EQ(alone.held_tip.x_m, found[k].held_tip.x_m);
    EXPECT_EQ(alone.held_tip.y_m, found[k].held_tip.y_m);
    EXPECT_EQ(alone.held_tip.theta_rad, found[k].held_tip.theta_rad);
  }
}

void expect_same_tree(const PressureTree& a, const PressureTree& b) {
  ASSERT_EQ(a.size(), b.size());
  for (int i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.parent(i), b.parent(i));
    EXPECT_EQ(a.cost_kpa(i), b.cost_kpa(i));
    EXPECT_TRUE(a.state(i) == b.state(i)) << "node " << i;
  }
}

TEST(BatchSearch, GrowsTheSameTreeForAnyNumberOfThreads) {
  const Setting s(true);
  Search one(s, 1);
  Search two(s, 2);
  one.rounds(20);
  two.rounds(20);
  expect_same_tree(one.search.tree(), two.search.tree());
  EXPECT_EQ(one.simulator.queries(), two.simulator.queries());
  Search other(s, 1, kSeed + 1);
  other.rounds(20);
  EXPECT_FALSE(Pressures(other.search.tree().setpoint_kpa(1)) ==
               Pressures(one.search.tree().setpoint_kpa(1)))
      << "the seed counts";
}

// By looking at all nodes: distance in tolerances.
TEST(BatchSearch, KnowsItsNodeNearestToTheGoal) {
  Setting s(true);
  s.environment.goal.theta_rad = 2.2;
  Search one(s);
  for (int k = 0; k < 15; ++k) {
    one.rounds(1);
    const PressureTree& tree = one.search.tree();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tree.size(); ++i) {
      least = std::min(least, goal_error(s.environment.goal, tree.settled_tip(i)));
    }
    EXPECT_EQ(goal_error(s.environment.goal, tree.settled_tip(one.search.nearest_node())), least);
  }
}

TEST(BatchSearch, EdgesFarDearerThanAPlanAreNotTried) {
  const Setting s(true);
  constexpr double kBestKpa = 60.0;
  DefaultPlannerSettings settings;
  settings.max_cost_ratio = 1.5;
  Search bounded(s, 1, kSeed, settings);
  bounded.rounds(20, kBestKpa);
  for (int i = 0; i < bounded.search.tree().size(); ++i) {
    EXPECT_LT(bounded.search.tree().cost_kpa(i), 1.5 * kBestKpa);
  }
  Search free(s, 1, kSeed, settings);
  free.rounds(20);
  EXPECT_GT(free.search.tree().size(), bounded.search.tree().size());
  EXPECT_LT(bounded.simulator.queries(), free.simulator.queries());
}

TEST(BatchSearch, AGraftIsAddedAsItIsAlsoWhereAStateLikeItStands) {
  const Setting s(false);
  Search one(s);
  MotionSimulator simulator(s.arm, s.model, one.checker);
  const Pressures to = Eigen::Vector3f(-20.0F, 10.0F, -15.0F);
  MotionState end;
  ASSERT_TRUE(simulator.move(start_of(one.problem), to, end));
  const int first = one.search.graft(0, end);
  const int second = one.search.graft(0, end);
  EXPECT_NE(first, second);
  for (const int node : {first, second}) {
    EXPECT_TRUE(one.search.tree().state(node) == end);
    EXPECT_NEAR(one.search.tree().cost_kpa(node), 45.0, 1e-4);
    EXPECT_EQ(one.search.tree().parent(node), 0);
  }
  const Pose tip{0.3, 0.4, 0.0};
  const BatchSearch::Solution solution = one.search.solution_at(second, tip);
  EXPECT_EQ(solution.node, second);
  EXPECT_EQ(solution.cost_kpa, one.search.tree().cost_kpa(second));
}

TEST(BatchSearch, ARoundThatIsGivenUpAddsNothingThatWasNotSimulated) {
  const Setting s(true);
  Search one(s);
  EXPECT_TRUE(one.search.round(std::nullopt, [] { return true; }).empty());
  EXPECT_EQ(one.search.tree().size(), 1);
  EXPECT_GT(one.search.proposals(), 0U);
}

}  // namespace
}  // namespace limber
