#include "limber/report/run_table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limber {
namespace {

PlanTrial run_of(const char* environment, const char* controller, const char* disturbance,
                 double distance_m) {
  PlanTrial trial;
  trial.environment = environment;
  trial.model = "network";
  trial.planner = "default";
  trial.controller = controller;
  trial.disturbance = disturbance;
  trial.planning.status = PlanStatus::solved;
  trial.planning.first_solution.emplace();
  trial.planning.plan.emplace();
  trial.planning.plan->frames.resize(41);
  trial.execution.emplace();
  trial.execution->frames = 50;
  trial.execution->final_backbone.emplace();
  trial.execution->goal_error.position_m = distance_m;
  trial.execution->goal_reached = distance_m < 0.02;
  return trial;
}

std::vector<RunRow> run_rows(const std::vector<PlanTrial>& trials) {
  RunCount count;
  for (const PlanTrial& trial : trials) {
    count.add(trial);
  }
  return count.rows();
}

TEST(RunTable, HasARowForEveryControllerAndDisturbanceOverAllEnvironments) {
  std::vector<PlanTrial> trials{run_of("a", "open", "", 0.01), run_of("b", "open", "", 0.03),
                                run_of("a", "replan", "", 0.01),
                                run_of("a", "replan", "friction", 0.01)};
  trials[2].execution->collided = true;
  const std::vector<RunRow> rows = run_rows(trials);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].executed, 2);
  EXPECT_EQ(rows[0].reached, 1);
  EXPECT_DOUBLE_EQ(*rows[0].distance_cm.mean, 2.0);
  EXPECT_DOUBLE_EQ(*rows[0].time_ratio.median, 50.0 / 40.0);
  EXPECT_EQ(rows[1].collided, 1);
  EXPECT_EQ(rows[1].reached, 0) << "it collided on the way";
  EXPECT_EQ(rows[2].disturbance, "friction");
  EXPECT_EQ(to_json(rows)[2]["disturbance"], "friction");
  EXPECT_EQ(run_table(rows).rows.size(), 3U);
}

TEST(RunTable, ARunThatWasNotSeenIsNoArrivalAndHasNoDistance) {
  std::vector<PlanTrial> trials{run_of("a", "open", "", 0.01), run_of("b", "open", "", 0.01)};
  trials[0].execution->final_backbone.reset();
  trials[0].execution->goal_reached = false;
  trials[0].execution->goal_error = {};
  const RunRow row = run_rows(trials).front();
  EXPECT_EQ(row.executed, 2);
  EXPECT_EQ(row.reached, 1);
  EXPECT_DOUBLE_EQ(*row.distance_cm.mean, 1.0);
  EXPECT_DOUBLE_EQ(*planning_row(trials, "", "").distance_cm.mean, 1.0);
}

TEST(RunTable, ARunThatWasStoppedCountsWithWhatItStruckAndAFaultDoesNot) {
  std::vector<PlanTrial> trials{run_of("a", "replan", "", 0.3), run_of("b", "replan", "", 0.4)};
  trials[0].execution->status = ExecutionStatus::stopped;
  trials[0].execution->collided = true;
  trials[1].execution->status = ExecutionStatus::fault;
  const RunRow row = run_rows(trials).front();
  EXPECT_EQ(row.executed, 1);
  EXPECT_EQ(row.stopped, 1);
  EXPECT_EQ(row.collided, 1);
  EXPECT_EQ(row.faults, 1);
  EXPECT_DOUBLE_EQ(*row.distance_cm.median, 30.0);
  const PlanningRow sum = planning_row(trials, "", "");
  EXPECT_EQ(sum.executed, 1);
  EXPECT_EQ(sum.collided, 1);
}

TEST(RunTable, TimesToTheGoalAreOfTheRunsThatEndThere) {
  std::vector<PlanTrial> trials{run_of("a", "replan", "", 0.01), run_of("b", "replan", "", 0.4)};
  trials[0].execution->goal_time_s = 3.0;
  trials[0].execution->planned_goal_time_s = 2.0;
  trials[1].execution->planned_goal_time_s = 2.0;
  EXPECT_DOUBLE_EQ(*run_rows(trials).front().goal_time_ratio.mean, 1.5);
}

TEST(RunTable, OnlyAStopForAnObstacleThatAppearedWithoutContactIsClean) {
  PlanTrial trial = run_of("a", "replan", "obstacle", 0.2);
  ExecutionResult& run = *trial.execution;
  EXPECT_FALSE(is_clean_stop(run));
  run.stopped_ahead = true;
  EXPECT_FALSE(is_clean_stop(run)) << "nothing appeared";
  run.appeared = AppearedObstacle{1.0, {0.3, 0.1, 0.02}};
  EXPECT_TRUE(is_clean_stop(run));
  EXPECT_EQ(run_rows({trial})[0].stopped_ahead, 1);
  EXPECT_FALSE(run_rows({trial})[0].distance_cm.median) << "it stopped where it had to";
  run.collided = true;
  EXPECT_FALSE(is_clean_stop(run));
  run.collided = false;
  run.goal_reached = true;
  EXPECT_FALSE(is_clean_stop(run)) << "it arrived";
}

}  // namespace
}  // namespace limber
