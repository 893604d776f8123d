#include "limber/report/planning_table.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/units.hpp"
#include "limber/report/run_table.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

PlanTrial trial(const char* environment, const char* model, double cost_kpa, double distance_m,
                bool collided = false, const char* planner = "default") {
  PlanTrial result;
  result.environment = environment;
  result.model = model;
  result.planner = planner;
  result.planning.status = PlanStatus::solved;
  result.planning.first_solution = FirstSolution{cost_kpa / 1000.0, 2.0 * cost_kpa};
  result.planning.plan.emplace();
  result.planning.plan->cost_kpa = cost_kpa;
  result.execution.emplace();
  result.execution->final_backbone.emplace();
  result.execution->goal_error.position_m = distance_m;
  result.execution->collided = collided;
  result.execution->goal_reached = distance_m < 0.02;
  return result;
}

std::string verdict(const std::vector<PlanningRow>& rows, const std::string& what) {
  for (const PaperFinding& finding : compare_with_paper(rows)) {
    if (finding.what.find(what) != std::string::npos) {
      return finding.verdict;
    }
  }
  return "no such finding";
}

TEST(SampleFigures, AreThoseOfElementaryStatistics) {
  const SampleFigures figures = figures_of({4.0, 1.0, 3.0, 2.0});
  EXPECT_EQ(figures.count, 4);
  EXPECT_DOUBLE_EQ(*figures.mean, 2.5);
  EXPECT_DOUBLE_EQ(*figures.median, 2.5);
  EXPECT_DOUBLE_EQ(*figures.p95, 3.85);
  EXPECT_DOUBLE_EQ(*figures.standard_error, std::sqrt(5.0 / 3.0 / 4.0));
  std::vector<double> hundred;
  for (int k = 100; k >= 1; --k) {
    hundred.push_back(k);
  }
  EXPECT_DOUBLE_EQ(*figures_of(hundred).p95, 95.05);
  EXPECT_FALSE(figures_of({}).mean);
  EXPECT_FALSE(figures_of({1.0}).standard_error);
}

TEST(PlanningTable, DistancesStandWithAndWithoutTheRunsThatCollided) {
  const std::vector<PlanTrial> trials{trial("a", "network", 100.0, 0.01),
                                      trial("a", "network", 200.0, 0.05, true)};
  const std::vector<PlanningRow> rows = planning_rows(trials);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].executed, 2);
  EXPECT_EQ(rows[0].collided, 1);
  EXPECT_EQ(rows[0].reached, 1);
  EXPECT_DOUBLE_EQ(*rows[0].distance_cm.mean, 3.0);
  EXPECT_DOUBLE_EQ(*rows[0].distance_free_cm.mean, 1.0);
  EXPECT_DOUBLE_EQ(*rows[0].cost_psi.mean, 150.0 / kKpaPerPsi);
  EXPECT_DOUBLE_EQ(*rows[0].first_solution_s.median, 0.15);
  EXPECT_FALSE(rows[0].orientation_rad.mean) << "no heading was asked for";
  ASSERT_TRUE(rows[0].one_plan);
  EXPECT_EQ(rows[0].one_plan->execution->goal_error.position_m, 0.01);
}

TEST(PlanningTable, ARowOfAllEnvironmentsCountsThoseOfItsModel) {
  std::vector<PlanTrial> trials{trial("a", "network", 100.0, 0.02),
                                trial("b", "network", 90.0, 0.10),
                                trial("a", "no_load", 80.0, 0.30)};
  trials[0].asks_heading = true;
  trials[0].execution->goal_error.orientation_rad = 0.3;
  EXPECT_EQ(planning_row(trials, "a", "").trials, 2);
  EXPECT_DOUBLE_EQ(*planning_row(trials, "", "network").distance_cm.mean, 6.0);
  EXPECT_DOUBLE_EQ(*planning_row(trials, "", "").orientation_rad.mean, 0.3);
  EXPECT_FALSE(planning_row(trials, "c", "").distance_cm.mean);
}

TEST(PlanningTable, RefusedPlansAreDefectsAndNotSolved) {
  std::vector<PlanTrial> trials{trial("a", "network", 100.0, 0.01)};
  trials[0].planning.status = PlanStatus::not_certified;
  trials[0].planning.plan.reset();
  trials[0].execution.reset();
  const PlanningRow row = planning_rows(trials).front();
  EXPECT_EQ(row.trials, 1);
  EXPECT_EQ(row.solved, 0);
  EXPECT_EQ(row.not_certified, 1);
  EXPECT_FALSE(row.one_plan);
}

TEST(PlanningTable, HasTheKeysOfItsContract) {
  const std::vector<PlanTrial> trials{trial("01", "no_load", 100.0, 0.1),
                                      trial("01", "network", 120.0, 0.01)};
  const nlohmann::ordered_json table = to_json(planning_rows(trials));
  ASSERT_EQ(table.size(), 2U);
  for (const char* key : {"environment", "model", "planner", "trials", "solved", "first_solution_s",
                          "first_candidate_s", "first_certificate_s", "cost_psi", "executed",
                          "collided", "distance_to_goal_cm", "orientation_to_goal_rad"}) {
    EXPECT_TRUE(table[0].contains(key)) << key;
  }
  for (const char* key : {"mean", "median", "p95", "standard_error"}) {
    EXPECT_TRUE(table[1]["first_solution_s"].contains(key)) << key;
  }
  EXPECT_TRUE(table[0]["cost_psi"]["standard_error"].is_null()) << "of one plan";
}

TEST(PaperFindings, AreJudgedOverEnvironmentsThatBothModelsHave) {
  const std::vector<PlanTrial> nearer{
      trial("a", "no_load", 100.0, 0.12), trial("a", "network", 140.0, 0.02),
      trial("b", "no_load", 100.0, 0.10, true), trial("b", "network", 150.0, 0.03)};
  const std::vector<PlanningRow> rows = planning_rows(nearer);
  EXPECT_EQ(verdict(rows, "collision-free runs"), "reproduced");
  EXPECT_EQ(verdict(rows, "cost more"), "reproduced");
  EXPECT_EQ(verdict(rows, "collide less"), "reproduced");
  EXPECT_EQ(verdict(rows, "orientation"), "not comparable");
  EXPECT_THAT(compare_with_paper(rows).front().here, HasSubstr("10.0 cm nearer, in 1"));
  const std::vector<PlanTrial> farther{trial("a", "no_load", 150.0, 0.02),
                                       trial("a", "network", 140.0, 0.12)};
  EXPECT_EQ(verdict(planning_rows(farther), "collision-free runs"), "not reproduced");
  EXPECT_EQ(verdict(planning_rows(farther), "cost more"), "not reproduced");
  const std::vector<PlanTrial> alone{trial("a", "network", 140.0, 0.12)};
  EXPECT_EQ(verdict(planning_rows(alone), "cost more"), "not comparable");
}

TEST(PlanningTable, IsMarkdownWithAsManyCellsInEveryRow) {
  const std::vector<PlanTrial> trials{trial("01", "no_load", 100.0, 0.1, true),
                                      trial("01", "network", 120.0, 0.01)};
  const std::string text = tables_to_markdown("T", planning_tables(planning_rows(trials)));
  EXPECT_THAT(text, HasSubstr("| 01 | No load | 1 | 0.1000 | 14.5 | Yes | N/A | N/A |"));
  EXPECT_THAT(text, HasSubstr("| 01 | Network | 1 | 0.1200 | 17.4 | No | 1.00 | N/A |"));
}

// The grammar of OMPL's benchmark logs, line by line.
TEST(PlannerArena, WritesARunALineUnderEachPlanner) {
  std::vector<PlanTrial> trials{
      trial("01", "network", 100.0, 0.1), trial("01", "network", 120.0, 0.1),
      trial("02", "network", 120.0, 0.1), trial("01", "network", 130.0, 0.1, false, "ompl:RRT")};
  trials[1].planning.status = PlanStatus::limit;
  trials[1].planning.plan.reset();
  trials[1].planning.first_solution.reset();
  trials[0].planning.events = {{0.1, 0, 9, 50, 200.0}, {2.0, 0, 90, 500, 100.0}};
  trials.push_back(trials[0]);  // the same plan, executed in another way
  trials.back().controller = "replan";
  PlannerLimits limits;
  limits.time_s = 2.5;
  const std::string log = planner_arena_log("01", trials, limits, 7);
  EXPECT_THAT(log, HasSubstr("\nExperiment 01\nRunning on "));
  EXPECT_THAT(log, HasSubstr("\n7 is the random seed\n2.5 seconds per run\n0 MB per run\n"
                             "2 runs per planner\n"));
  EXPECT_THAT(log, HasSubstr("\n1 enum type\nstatus|solved|limit|"));
  EXPECT_THAT(log, HasSubstr("\n2 planners\ncontrol_default_network\n0 common properties\n"
                             "9 properties for each run\ntime REAL\n"));
  EXPECT_THAT(log, HasSubstr("\nstatus ENUM\n2 runs\n0; 1; 1; 100; 0.1; 200; 0; 0; 0; \n"
                             "0; 0; 0; ; ; ; 0; 0; 1; \n"
                             "2 progress properties for each run\ntime REAL\nbest cost REAL\n"
                             "2 runs\n0.1,200,;2,100,;\n\n.\ncontrol_ompl:RRT_network\n"));
  EXPECT_EQ(log.substr(log.size() - 2), ".\n");
}

}  // namespace
}  // namespace limber
