#include "limber/run/plan_trial.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limber {
namespace {

PlanTrial solved_trial(const char* environment, const char* model, double cost_kpa) {
  PlanTrial trial;
  trial.environment = environment;
  trial.model = model;
  trial.planning.status = PlanStatus::solved;
  trial.planning.first_solution = FirstSolution{0.5, cost_kpa};
  trial.planning.plan.emplace();
  trial.planning.plan->cost_kpa = cost_kpa;
  return trial;
}

PlanTrial executed_trial(const char* model, double distance_m, bool collided) {
  PlanTrial trial = solved_trial("a", model, 100.0);
  trial.execution.emplace();
  trial.execution->final_backbone.emplace();
  trial.execution->goal_error.position_m = distance_m;
  trial.execution->collided = collided;
  return trial;
}

TEST(PlanTrials, DistanceCountsRunsThatCollidedAndIsGivenWithoutThemToo) {
  const std::vector<PlanTrial> trials = {executed_trial("network", 0.02, false),
                                         executed_trial("network", 0.10, true),
                                         executed_trial("no_load", 0.30, false)};
  const TrialSummary sum = summarise(trials, "", "network");
  EXPECT_EQ(sum.solved, 2);
  EXPECT_EQ(sum.collided, 1);
  EXPECT_DOUBLE_EQ(*sum.distance_m, 0.06);
  EXPECT_DOUBLE_EQ(*sum.distance_free_m, 0.02);
}

TEST(PlanTrials, OrientationIsOverGoalsThatAskForAHeading) {
  std::vector<PlanTrial> trials = {executed_trial("network", 0.02, false),
                                   executed_trial("network", 0.02, false)};
  EXPECT_FALSE(summarise(trials, "", "").orientation_rad.has_value());
  trials[0].asks_heading = true;
  trials[0].execution->goal_error.orientation_rad = 0.3;
  EXPECT_DOUBLE_EQ(*summarise(trials, "", "").orientation_rad, 0.3);
}

TEST(PlanTrials, WithoutAPlanCountAsTrialsOnly) {
  std::vector<PlanTrial> trials = {executed_trial("network", 0.02, false), PlanTrial{}};
  trials[1].environment = "a";
  trials[1].model = "network";
  const TrialSummary sum = summarise(trials, "a", "network");
  EXPECT_EQ(sum.trials, 2);
  EXPECT_EQ(sum.solved, 1);
  EXPECT_DOUBLE_EQ(*sum.distance_m, 0.02);
  EXPECT_EQ(summarise(trials, "b", "").trials, 0);
  EXPECT_FALSE(summarise(trials, "b", "").distance_m.has_value());
}

TEST(PlanTrials, CheapestPlanIsSoughtAmongThoseAskedFor) {
  const std::vector<PlanTrial> trials = {solved_trial("a", "no_load", 50.0),
                                         solved_trial("a", "network", 90.0),
                                         solved_trial("a", "network", 80.0), PlanTrial{}};
  EXPECT_EQ(cheapest_plan(trials, "a", "network"), &trials[2]);
  EXPECT_EQ(cheapest_plan(trials, "", ""), &trials[0]);
  EXPECT_EQ(cheapest_plan(trials, "b", "network"), nullptr);
}

// Test and training data must not share their chance, whatever seed the user gives.

}  // namespace
}  // namespace limber
