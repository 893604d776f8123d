#include "src/planning/plan_ladder.hpp"

#include <gmock/gmock.h>

#include "planning/planner_setting.hpp"
#include "src/planning/certified/certified_planner.hpp"
#include "src/planning/plan_result.hpp"
#include "src/planning/search/default_planner.hpp"
#include "src/planning/search/plan_improver.hpp"

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

/// Its cheapest plan goes straight through whatever stands in the way.
class Reckless final : public Planner {
 public:
  Reckless(std::vector<Pressures> sound, std::vector<Pressures> reckless)
      : sound_(std::move(sound)), reckless_(std::move(reckless)) {}
  const char* name() const override { return "reckless"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
    MotionSimulator simulator(problem.arm, problem.model, checker);
    PlannerBudget budget(limits, callback);
    PlanLadder ladder(problem, simulator, budget, name(), seed);
    (void)ladder.offer(sound_, path_cost_kpa(sound_), 1);
    (void)ladder.offer(reckless_, path_cost_kpa(reckless_), 2);
    PlanResult result;
    finish_search(problem, simulator, budget, {ladder, 2, sound_}, name(), seed, result);
    return result;
  }

 private:
  std::vector<Pressures> sound_, reckless_;
};

TEST(CertifiedPlanner, ReturnsTheBestPlanThatItsCertificateLetsStand) {
  Setting s(false);
  const PlanResult sound = s.plan("default", 1500);
  ASSERT_TRUE(sound.plan);
  const std::vector<Pressures>& way = sound.plan->waypoints_kpa;
  const std::vector<Pressures> straight{way.front(), way.back()};
  ASSERT_LT(motion_cost_kpa(way.front(), way.back()), 0.95 * sound.plan->cost_kpa)
      << "no way round: nothing would be refused";
  const PlanResult result = make_certified_planner(std::make_unique<Reckless>(way, straight))
                                ->plan({s.arm, s.model, s.environment},
                                       [] {
                                         PlannerLimits limits;
                                         limits.iterations = 1;
                                         return limits;
                                       }(),
                                       1, {});
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.plan->waypoints_kpa.size(), way.size());
  EXPECT_TRUE(result.certificate->certified());
  EXPECT_GT(result.first_solution->certificate_s, 0.0);
  expect_lawful(s, *result.plan);
}

TEST(DefaultPlanner, SearchesOnFromWhatItsJudgeLetsStand) {
  Setting s(false);
  PlannerLimits limits;
  limits.iterations = 1500;
  const double min_kpa =
      make_default_planner()->plan({s.arm, s.model, s.environment}, limits, 3).plan->cost_kpa;
  Dear judge(1.05 * min_kpa);
  const PlanningProblem judged{s.arm, s.model,      s.environment, 0.0,
                               {},    std::nullopt, nullptr,       &judge};
  const PlanResult result = make_default_planner()->plan(judged, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GE(result.plan->cost_kpa, 1.05 * min_kpa);
  EXPECT_LE(result.plan->cost_kpa, 1.3 * min_kpa);
}

}  // namespace
}  // namespace limber
