#include "src/planning/plan_ladder.hpp"

#include <gmock/gmock.h>

#include "limber/planning/plan_builder.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class PlanResults : public ::testing::Test {
 protected:
  static PlannerLimits limits() {
    PlannerLimits limits;
    limits.iterations = 100;
    return limits;
  }
  static PlannerProgress progress(double cost_kpa) { return {0.0, 1, 1, 1, cost_kpa}; }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  MotionSimulator simulator_{setting_.arm, setting_.model, checker_};
  PlannerBudget budget_{limits(), {}};
  PlanLadder ladder_{problem_, simulator_, budget_, "test", 7};
  std::vector<Pressures> aside_kpa_{Pressures::Zero(3), Eigen::Vector3f(-20.0F, 10.0F, 0.0F)};
};

TEST_F(PlanResults, ARefusalIsTheProblemsOwn) {
  PlanResult result;
  EXPECT_FALSE(is_refused(problem_, checker_, result));
  setting_.environment.goal.x_m = 3.0;
  EXPECT_TRUE(is_refused(problem_, checker_, result));
  EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
  EXPECT_THAT(result.reason, HasSubstr("beyond the arm's reach"));
}

TEST_F(PlanResults, WithoutAPlanTheNearestMotionAndWhySearchingEndedAreTold) {
  EXPECT_TRUE(budget_.spent({0.0, 100, 1, 1, std::nullopt}, 1.0));
  PlanResult result;
  result.statistics.nodes = 55;
  ladder_.finish(10, aside_kpa_, result);
  EXPECT_EQ(result.status, PlanStatus::limit);
  EXPECT_EQ(result.limit, PlanLimit::iterations);
  EXPECT_FALSE(result.plan);
  ASSERT_TRUE(result.best_partial);
  EXPECT_EQ(result.best_partial->waypoints_kpa, aside_kpa_);
  EXPECT_THAT(result.reason,
              AllOf(HasSubstr("100 iterations spent, 55 nodes, seed 7; the nearest motion ends "),
                    HasSubstr("cm from the goal (tolerance 2.0 cm)")));
}

TEST_F(PlanResults, AnOfferedPlanIsTheResult) {
  EXPECT_TRUE(ladder_.offer(aside_kpa_, 30.0, 5));
  PlanResult result;
  ladder_.finish(10, {}, result);
  EXPECT_EQ(result.status, PlanStatus::solved);
  EXPECT_EQ(result.plan->waypoints_kpa, aside_kpa_);
  EXPECT_EQ(result.first_solution->queries, 5U);
  EXPECT_FALSE(result.limit);
}

// Events that were cheaper than the plan belonged to plans that did not hold.
TEST_F(PlanResults, EventsEndWithThePlanAndNoneIsCheaper) {
  for (const double cost_kpa : {90.0, 60.0, 30.0, 20.0, 10.0}) {
    budget_.note(progress(cost_kpa));
  }
  PlanResult result;
  result.plan = build_plan(problem_, simulator_, aside_kpa_, "test", 7);
  result.statistics.queries = 500;
  PressureTree tree(problem_.model);
  tree.add(start_of(problem_), -1, 0.0);
  close_search(budget_, tree, {0.0, 77, 8, 400, 10.0}, result);
  ASSERT_EQ(result.events.size(), 4U);
  for (const PlannerProgress& event : result.events) {
    EXPECT_GE(*event.best_cost_kpa, result.plan->cost_kpa - 1e-3);
  }
  EXPECT_EQ(result.events.back().iterations, 77U);
  EXPECT_EQ(result.events.back().queries, 500U);
  EXPECT_EQ(*result.events.back().best_cost_kpa, result.plan->cost_kpa);
  EXPECT_TRUE(result.tree.empty());
}

// With an aim plans get dearer; their first one is told all the same.
TEST_F(PlanResults, EventsBeginWithTheFirstPlanAndKeepNoTree) {
  for (const double cost_kpa : {20.0, 10.0}) {
    budget_.note(progress(cost_kpa));
  }
  PlanResult result;
  result.plan = build_plan(problem_, simulator_, aside_kpa_, "test", 7);
  result.first_solution = FirstSolution{.cost_kpa = 20.0};
  PressureTree tree(problem_.model);
  tree.add(start_of(problem_), -1, 0.0);
  PlannerProgress end = progress(10.0);
  end.tree = [] { return std::vector<TreeEdge>(); };
  close_search(budget_, tree, end, result);
  ASSERT_EQ(result.events.size(), 2U);
  EXPECT_EQ(*result.events.front().best_cost_kpa, 20.0);
  EXPECT_FALSE(result.events.back().tree) << "what it would ask is gone";
}

TEST_F(PlanResults, TheTreeForPicturesLeadsFromTipToTip) {
  PressureTree tree(problem_.model);
  tree.add(start_of(problem_), -1, 0.0);
  RandomStream random(1, 1);
  for (int i = 1; i < 50; ++i) {
    MotionState end;
    simulator_.move_unchecked(tree.state(i / 2), random_pressures(setting_.arm, random), end);
    tree.add(end, i / 2, 1.0);
  }
  PlanResult result;
  close_search(budget_, tree, {}, result);
  ASSERT_EQ(result.tree.size(), 49U);
  EXPECT_TRUE(result.events.empty()) << "there is no plan";
  for (int i = 1; i < 50; ++i) {
    const TreeEdge& edge = result.tree[static_cast<std::size_t>(i - 1)];
    EXPECT_EQ(edge.to_m.x(), tree.backbone(i)(15, 0));
    EXPECT_EQ(edge.to_m.y(), tree.backbone(i)(15, 1));
    EXPECT_EQ(edge.from_m.x(), tree.backbone(tree.parent(i))(15, 0));
  }
}

}  // namespace
}  // namespace limber
