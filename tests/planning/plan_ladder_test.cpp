#include "src/planning/plan_ladder.hpp"

#include <gmock/gmock.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

/// Refuses what is cheaper than it likes, and remembers what it was asked.
class Dear final : public PlanJudge {
 public:
  explicit Dear(double min_kpa) : min_kpa_(min_kpa) {}

  Verdict judge(Plan& plan, const std::function<bool()>&) override {
    asked_kpa.push_back(plan.cost_kpa);
    return plan.cost_kpa >= min_kpa_ ? Verdict::holds : Verdict::refused;
  }

  std::vector<double> asked_kpa;

 private:
  double min_kpa_;
};

class Slow final : public PlanJudge {
 public:
  Verdict judge(Plan&, const std::function<bool()>&) override { return Verdict::unfinished; }
};

/// Plans along a straight line in pressure, `extra_kpa` dearer than the way there needs.
std::vector<Pressures> detour(const Pressures& to, float extra_kpa) {
  const Pressures start = Pressures::Zero(to.size());
  Pressures beyond = to;
  beyond[0] += 0.5F * extra_kpa * (to[0] < 0.0F ? -1.0F : 1.0F);
  return {start, beyond, to};
}

struct Ladder {
  Setting setting{false};
  PlanningProblem problem{setting.arm, setting.model, setting.environment};
  CollisionChecker checker{setting.arm, {}};
  MotionSimulator simulator{setting.arm, setting.model, checker};
  PlannerLimits limits = [] {
    PlannerLimits some;
    some.iterations = 10;
    return some;
  }();
  PlannerCallback nobody;
  PlannerBudget budget{limits, nobody};
  Pressures goal_kpa = Pressures::Constant(3, 20.0F);

  PlanLadder ladder{problem, simulator, budget, "test", 1};

  /// In the open, with a goal that a planner has reached.
  Ladder() {
    setting.environment.obstacles.clear();
    goal_kpa = setting.plan("default", 400).plan->waypoints_kpa.back();
  }
  bool offer(float extra_kpa, std::uint64_t queries) {
    return ladder.offer(detour(goal_kpa, extra_kpa), cost_kpa(extra_kpa), queries);
  }
  double cost_kpa(float extra_kpa) const { return goal_kpa.lpNorm<1>() + extra_kpa; }
};

TEST(PlanLadder, ARefusedPlanTakesThoseBeforeItAlong) {
  Ladder s;
  Dear judge(s.cost_kpa(19.9F));
  s.problem.judge = &judge;
  EXPECT_TRUE(s.offer(22.0F, 5));
  EXPECT_TRUE(s.offer(21.0F, 6));
  EXPECT_TRUE(s.offer(20.0F, 7));
  EXPECT_TRUE(s.offer(19.0F, 8));
  EXPECT_TRUE(s.offer(18.0F, 9));
  EXPECT_EQ(judge.asked_kpa.size(), 1U) << "a per cent or so is not worth a certificate yet";
  PlanResult result;
  EXPECT_TRUE(s.ladder.settle(result, 10));
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_NEAR(result.plan->cost_kpa, s.cost_kpa(20.0F), 1e-2) << "the cheapest that holds";
  EXPECT_EQ(judge.asked_kpa.size(), 4U) << "from the best down";
  EXPECT_EQ(result.first_solution->queries, 5U);
}

TEST(PlanLadder, WhatIsNotablyCheaperIsJudgedAtOnceAndNotBuiltUponWhereItIsRefused) {
  Ladder s;
  Dear judge(s.cost_kpa(50.0F));
  s.problem.judge = &judge;
  EXPECT_TRUE(s.offer(100.0F, 1));
  EXPECT_FALSE(s.offer(5.0F, 2));
  EXPECT_EQ(judge.asked_kpa.size(), 2U);
  EXPECT_NEAR(*s.ladder.best_cost_kpa(), s.cost_kpa(100.0F), 1e-2);
}

TEST(PlanLadder, WithEveryPlanRefusedTheCheapestIsKeptAsNoSolution) {
  Ladder s;
  Dear judge(1e9);
  s.problem.judge = &judge;
  EXPECT_FALSE(s.offer(9.0F, 1));
  EXPECT_FALSE(s.offer(8.0F, 1));
  EXPECT_FALSE(s.ladder.best_cost_kpa());
  PlanResult result;
  EXPECT_TRUE(s.ladder.settle(result, 1));
  EXPECT_EQ(result.status, PlanStatus::not_certified);
  EXPECT_FALSE(result.plan);
  EXPECT_FALSE(result.first_solution);
  EXPECT_NEAR(result.best_partial->cost_kpa, s.cost_kpa(8.0F), 1e-2);
}

TEST(PlanLadder, APlanWhoseJudgeRanOutOfTimeIsNoSolution) {
  Ladder s;
  Slow judge;
  s.problem.judge = &judge;
  EXPECT_TRUE(s.offer(9.0F, 1));
  PlanResult result;
  EXPECT_TRUE(s.ladder.settle(result, 1));
  EXPECT_EQ(result.status, PlanStatus::limit);
  EXPECT_THAT(result.reason, HasSubstr("certificate was not finished"));
  EXPECT_FALSE(result.plan);
}

}  // namespace
}  // namespace limber
