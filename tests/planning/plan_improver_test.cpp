#include "src/planning/search/plan_improver.hpp"

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "planning/walk.hpp"

namespace limber {
namespace {

constexpr std::uint64_t kSeed = 5;

const auto kNever = [] { return false; };

/// A plan from the tree alone, to be improved.
class Improver : public ::testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    const PlanResult bare = setting_.plan("default,improved_plans=0", 1500);
    ASSERT_TRUE(bare.plan) << bare.reason;
    first_kpa_ = bare.plan->waypoints_kpa;
    ASSERT_TRUE(adopt(improver_));
  }

  bool adopt(PlanImprover& improver) {
    const Walk first = walk(problem_, checker_, first_kpa_);
    improver.adopt(first_kpa_, first.states, first.held_tip);
    return ends_in_goal(problem_, first);
  }

  std::vector<PathOutcome> simulated(const PlanImprover& improver,
                                     const std::vector<PlanImprover::Change>& changes) {
    std::vector<Path> paths;
    for (const PlanImprover::Change& change : changes) {
      paths.push_back(improver.path_of(change));
    }
    return simulator_.run(paths, kNever);
  }

  void round(PlanImprover& improver) {
    std::vector<PlanImprover::Change> changes = improver.propose();
    const std::vector<PathOutcome> outcomes = simulated(improver, changes);
    improver.settle(std::move(changes), outcomes);
  }

  /// From the start, one frame after another: free, in the goal, and what the improver says.
  void expect_sound(const PlanImprover& improver) {
    const Walk alone = walk(problem_, checker_, improver.waypoints_kpa());
    ASSERT_TRUE(alone.is_free);
    EXPECT_TRUE(ends_in_goal(problem_, alone));
    ASSERT_EQ(improver.states().size(), alone.states.size());
    for (std::size_t i = 0; i < alone.states.size(); ++i) {
      EXPECT_TRUE(improver.states()[i] == alone.states[i]) << "waypoint " << i;
    }
    const GoalAim aim(problem_);
    EXPECT_EQ(improver.merit_kpa(),
              aim.merit_kpa(path_cost_kpa(improver.waypoints_kpa()), alone.held_tip));
    for (const Pressures& kpa : improver.waypoints_kpa()) {
      EXPECT_EQ(setpoints_of(problem_).limited(kpa), kpa);
    }
  }

  Setting setting_{GetParam()};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  CollisionChecker checker_{setting_.arm, setting_.environment.obstacles};
  PathSimulator simulator_{problem_, checker_, {0.05, 0.5}, 1};
  SecondOpinions opinions_{problem_, checker_};
  PlanImprover improver_{problem_, opinions_, kSeed, 0};
  Waypoints first_kpa_;
};

TEST_P(Improver, PlansNeverGetDearerAndStayFreeAndInTheGoal) {
  double before_kpa = improver_.merit_kpa();
  EXPECT_EQ(before_kpa, path_cost_kpa(first_kpa_));
  int accepted = 0;
  for (int k = 0; k < 150; ++k) {
    round(improver_);
    EXPECT_LE(improver_.merit_kpa(), before_kpa);
    if (improver_.merit_kpa() < before_kpa) {
      ++accepted;
      expect_sound(improver_);
    }
    before_kpa = improver_.merit_kpa();
  }
  EXPECT_GT(accepted, 10);
  EXPECT_LT(improver_.merit_kpa(), 0.9 * path_cost_kpa(first_kpa_));
}

TEST_P(Improver, ProposesCheaperPlansThatGoOnFromWhereTheyFirstDiffer) {
  int proposed = 0;
  for (int k = 0; k < 30; ++k) {
    std::vector<PlanImprover::Change> changes = improver_.propose();
    for (const PlanImprover::Change& change : changes) {
      ++proposed;
      EXPECT_EQ(change.cost_kpa, path_cost_kpa(change.waypoints_kpa));
      EXPECT_LT(change.cost_kpa, improver_.merit_kpa());
      ASSERT_GE(change.same, 1U);
      ASSERT_LT(change.same, change.waypoints_kpa.size());
      for (std::size_t i = 0; i < change.same; ++i) {
        EXPECT_EQ(change.waypoints_kpa[i], improver_.waypoints_kpa()[i]);
      }
      const Path path = improver_.path_of(change);
      EXPECT_TRUE(path.from == improver_.states()[change.same - 1]);
      EXPECT_EQ(path.to_kpa.size() + change.same, change.waypoints_kpa.size());
      EXPECT_EQ(path.to_kpa.back(), change.waypoints_kpa.back());
    }
    const std::vector<PathOutcome> outcomes = simulated(improver_, changes);
    improver_.settle(std::move(changes), outcomes);
  }
  EXPECT_GT(proposed, 100);
}

TEST_P(Improver, DependsOnItsSeedAndStreamAlone) {
  PlanImprover same(problem_, opinions_, kSeed, 0);
  PlanImprover other(problem_, opinions_, kSeed, 1);
  adopt(same);
  adopt(other);
  for (int k = 0; k < 20; ++k) {
    round(improver_);
    round(same);
    round(other);
  }
  EXPECT_EQ(same.waypoints_kpa(), improver_.waypoints_kpa());
  EXPECT_NE(other.waypoints_kpa(), improver_.waypoints_kpa());
}

TEST_P(Improver, OfChangesThatHoldTheBestIsAcceptedAndOthersAreNot) {
  std::vector<PlanImprover::Change> changes = improver_.propose();
  ASSERT_GE(changes.size(), 3U);
  std::size_t best = 0;
  std::vector<PathOutcome> outcomes(changes.size());
  for (std::size_t k = 0; k < changes.size(); ++k) {
    best = changes[k].cost_kpa < changes[best].cost_kpa ? k : best;
    outcomes[k].free = true;
    outcomes[k].in_goal = true;
    outcomes[k].held_tip = Pose{setting_.environment.goal.x_m, setting_.environment.goal.y_m, 0.0};
    outcomes[k].at.resize(changes[k].waypoints_kpa.size() - changes[k].same);
  }
  // The cheapest of all is said to collide: the next best is taken.
  outcomes[best] = PathOutcome();
  double next_kpa = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < changes.size(); ++k) {
    next_kpa = k == best ? next_kpa : std::min(next_kpa, changes[k].cost_kpa);
  }
  improver_.settle(changes, outcomes);
  EXPECT_EQ(improver_.merit_kpa(), next_kpa);
  EXPECT_EQ(improver_.states().size(), improver_.waypoints_kpa().size());
}

TEST_P(Improver, RoundsWithoutSuccessAreCountedAndChangeNothing) {
  for (int k = 1; k <= 5; ++k) {
    std::vector<PlanImprover::Change> changes = improver_.propose();
    const std::vector<PathOutcome> colliding(changes.size());
    improver_.settle(std::move(changes), colliding);
    EXPECT_EQ(improver_.fruitless_rounds(), k);
    EXPECT_EQ(improver_.waypoints_kpa(), first_kpa_);
  }
  adopt(improver_);
  EXPECT_EQ(improver_.fruitless_rounds(), 0);
  improver_.drop();
  EXPECT_FALSE(improver_.has_plan());
}

// What ends beside the goal is shifted back into it in the next round, by the no-load model: where
// that is the arm, mostly with success.
TEST_P(Improver, WhatJustMissesTheGoalIsTakenBackIntoIt) {
  const PoseGoal& goal = setting_.environment.goal;
  int repaired = 0, back = 0;
  for (int k = 0; k < 60; ++k) {
    std::vector<PlanImprover::Change> changes = improver_.propose();
    const std::vector<PathOutcome> outcomes = simulated(improver_, changes);
    std::size_t misses = 0;
    for (const PathOutcome& outcome : outcomes) {
      misses += outcome.held_tip && !outcome.in_goal &&
                        pose_error(goal, *outcome.held_tip).position_m < 0.03
                    ? 1
                    : 0;
    }
    improver_.settle(std::move(changes), outcomes);
    if (misses == 0) {
      continue;
    }
    const std::vector<PlanImprover::Change> next = improver_.propose();
    const std::vector<PathOutcome> after = simulated(improver_, next);
    if (!next.empty() && after.front().held_tip) {
      ++repaired;
      back += pose_error(goal, *after.front().held_tip).position_m < 0.021 ? 1 : 0;
    }
  }
  EXPECT_GT(repaired, 10);
  EXPECT_GT(back, (GetParam() ? 0.3 : 0.7) * repaired) << back << " of " << repaired;
}

TEST_P(Improver, AnAimIsComeNearerToEvenWhereThatCosts) {
  problem_.aim = PoseError{0.25 * setting_.environment.goal.position_tolerance_m, 0.1};
  PlanImprover aiming(problem_, opinions_, kSeed, 0);
  adopt(aiming);
  const GoalAim aim(problem_);
  const double before = aim.beyond(walk(problem_, checker_, aiming.waypoints_kpa()).held_tip);
  for (int k = 0; k < 100; ++k) {
    round(aiming);
  }
  expect_sound(aiming);
  const double after = aim.beyond(walk(problem_, checker_, aiming.waypoints_kpa()).held_tip);
  EXPECT_LE(after, before);
  EXPECT_LT(after, 0.05);
}

INSTANTIATE_TEST_SUITE_P(OfPlans, Improver, ::testing::Bool(), [](const auto& play) {
  return play.param ? "WithPlay" : "WithoutMemory";
});

TEST(PlanImprover, APlanThatStandsStillHasNothingToChange) {
  const Setting s(false);
  const PlanningProblem problem{s.arm, s.model, s.environment};
  const CollisionChecker checker(s.arm, {});
  SecondOpinions opinions(problem, checker);
  PlanImprover improver(problem, opinions, 1, 0);
  EXPECT_FALSE(improver.has_plan());
  const MotionState start = start_of(problem);
  improver.adopt({start.setpoint_kpa()}, {start}, {0.3, 0.4, 0.0});
  EXPECT_TRUE(improver.has_plan());
  EXPECT_TRUE(improver.propose().empty());
  improver.settle({}, {});
  EXPECT_EQ(improver.merit_kpa(), 0.0);
}

}  // namespace
}  // namespace limber
