#include "src/planning/search/plan_improver.hpp"

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

const auto kNever = [] { return false; };

/// A search that has found some plans, and a ladder that they are offered to.
struct Work {
  explicit Work(const Setting& s, int team_size = 3, int jobs = 1)
      : problem{s.arm, s.model, s.environment},
        checker(s.arm, s.environment.obstacles),
        single(s.arm, s.model, checker),
        opinions(problem, checker),
        simulator(problem, checker, {0.05, 0.5}, jobs),
        search(problem, simulator, {}, 3),
        team(problem, opinions, team_size, 3),
        budget(some_limits(), {}),
        ladder(problem, single, budget, "test", 3) {
    for (int found = 0; found < 8;) {
      for (const BatchSearch::Solution& one : search.round(std::nullopt, kNever)) {
        ++found;
        team.add(one);
        if (!ladder.best_cost_kpa() || one.cost_kpa < *ladder.best_cost_kpa()) {
          EXPECT_TRUE(ladder.offer(search.waypoints_to(one.node), one.cost_kpa, 1));
        }
      }
    }
  }

  static PlannerLimits some_limits() {
    PlannerLimits limits;
    limits.iterations = 10;
    return limits;
  }

  /// @param stands  whether what is offered may be built upon
  bool round(bool stands = true) {
    return team.round(
        search, simulator, ladder,
        [&](const Waypoints& waypoints_kpa, double merit_kpa) {
          offered_kpa.push_back(merit_kpa);
          offered.push_back(waypoints_kpa);
          return stands && ladder.offer(waypoints_kpa, merit_kpa, 1);
        },
        kNever);
  }

  PlanningProblem problem;
  CollisionChecker checker;
  MotionSimulator single;
  SecondOpinions opinions;
  PathSimulator simulator;
  BatchSearch search;
  ImproverTeam team;
  PlannerBudget budget;
  PlanLadder ladder;
  std::vector<double> offered_kpa;
  std::vector<Waypoints> offered;
};

TEST(ImproverTeam, WhatItOffersIsBetterEachTimeAndHolds) {
  const Setting s(true);
  Work work(s);
  double before_kpa = *work.ladder.best_merit_kpa();
  for (int k = 0; k < 80; ++k) {
    EXPECT_TRUE(work.round());
  }
  ASSERT_GT(work.offered.size(), 5U);
  for (std::size_t k = 0; k < work.offered.size(); ++k) {
    EXPECT_LT(work.offered_kpa[k], before_kpa);
    before_kpa = work.offered_kpa[k];
    EXPECT_EQ(before_kpa, path_cost_kpa(work.offered[k]));
    EXPECT_TRUE(ends_in_goal(work.problem, walk(work.problem, work.checker, work.offered[k])));
  }
  EXPECT_EQ(*work.ladder.best_merit_kpa(), before_kpa);
}

TEST(ImproverTeam, EveryPlanThatWaitsHasItsTurnOnce) {
  const Setting s(false);
  Work work(s);
  std::size_t waiting = work.team.waiting_count();
  EXPECT_GE(waiting, 8U);
  EXPECT_TRUE(work.round());
  EXPECT_EQ(work.team.waiting_count(), waiting - 3) << "one for each place";
  for (int k = 0; k < 3000 && work.team.waiting_count() > 0; ++k) {
    waiting = work.team.waiting_count();
    EXPECT_TRUE(work.round());
    EXPECT_GE(work.team.waiting_count() + 3, waiting);
    EXPECT_LE(work.team.waiting_count(), waiting);
  }
  EXPECT_EQ(work.team.waiting_count(), 0U);
}

TEST(ImproverTeam, WhatMayNotBeBuiltUponIsDroppedForTheNext) {
  const Setting s(false);
  Work work(s, 1);
  const std::size_t waiting = work.team.waiting_count();
  std::size_t rounds = 0;
  while (work.round(false) && rounds < 2000) {
    ++rounds;
  }
  EXPECT_LT(rounds, 2000U) << "in the end there is none left";
  EXPECT_EQ(work.team.waiting_count(), 0U);
  EXPECT_GT(work.offered.size(), 1U);
  EXPECT_LE(work.offered.size(), waiting) << "each is refused once";
}

TEST(ImproverTeam, DoesTheSameForAnyNumberOfThreads) {
  const Setting s(true);
  Work one(s, 3, 1);
  Work two(s, 3, 2);
  for (int k = 0; k < 20; ++k) {
    one.round();
    two.round();
  }
  EXPECT_EQ(one.offered, two.offered);
  EXPECT_EQ(one.simulator.queries(), two.simulator.queries());
}

TEST(ImproverTeam, WithoutAPlaceOrAPlanHasNothingToTry) {
  const Setting s(false);
  Work none(s, 0);
  EXPECT_FALSE(none.round());
  const std::uint64_t queries = none.simulator.queries();
  EXPECT_FALSE(none.round());
  EXPECT_EQ(none.simulator.queries(), queries);
}

}  // namespace
}  // namespace limber
