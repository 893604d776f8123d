#include "src/lab/improve/round_figures.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limber {
namespace {

using ::testing::HasSubstr;

constexpr double kRounding = 1e-12;

PlanRun ended(double distance_m, bool collided, bool arrived) {
  return {0, "solved", true, collided, arrived, distance_m, 2.0};
}

std::vector<PlanRun> some_runs() {
  PlanRun unsolved;
  unsolved.status = "limit";
  return {ended(0.01, false, true), ended(0.03, true, false), unsolved, ended(0.02, false, true),
          ended(0.06, false, false)};
}

TEST(RoundFigures, CountAndDistancesAreThoseOfTheRuns) {
  const PlanFigures figures = figures_of(some_runs());
  EXPECT_EQ(figures.environments, 5);
  EXPECT_EQ(figures.solved, 4);
  EXPECT_EQ(figures.executed, 4);
  EXPECT_EQ(figures.collided, 1);
  EXPECT_EQ(figures.arrived, 2);
  EXPECT_NEAR(figures.mean_m.value(), 0.03, kRounding);
  EXPECT_NEAR(figures.median_m.value(), 0.025, kRounding);
  // Squares of −2, 0, −1, 3 cm: 14 cm²; over 3 and 4.
  EXPECT_NEAR(figures.standard_error_m.value(), 0.01 * std::sqrt(14.0 / 12.0), kRounding);
}

TEST(RoundFigures, NothingExecutedHasNoDistance) {
  const PlanFigures figures = figures_of({PlanRun{}});
  EXPECT_EQ(figures.environments, 1);
  EXPECT_FALSE(figures.mean_m);
  EXPECT_FALSE(figures.standard_error_m);
  EXPECT_FALSE(figures.median_m);
}

TEST(RoundFigures, EndDistancesKeepThePlaceOfEachEnvironment) {
  const EndDistances distances = end_distances(some_runs());
  ASSERT_EQ(distances.size(), 5U);
  EXPECT_EQ(distances[1], 0.03);
  EXPECT_FALSE(distances[2]);
}

RoundFigures round_of(int number, double plans_m, double motions_m) {
  RoundFigures round;
  round.round = number;
  round.reported = figures_of(some_runs());
  round.selection = round.reported;
  round.selection_m = end_distances(some_runs());
  round.on_plans = {4, plans_m, 2.0 * plans_m};
  round.on_motions = {motions_m > 0.0 ? 4 : 0, motions_m, 3.0 * motions_m};
  return round;
}

TEST(RoundFigures, RatioIsThatOfTheErrorsAndNoneOverNothing) {
  const RoundFigures round = round_of(0, 0.03, 0.02);
  EXPECT_NEAR(round.mean_error_ratio().value(), 1.5, kRounding);
  EXPECT_NEAR(round.largest_error_ratio().value(), 1.0, kRounding);
  EXPECT_FALSE(round_of(0, 0.03, 0.0).mean_error_ratio());
  EXPECT_TRUE(to_json(round_of(0, 0.03, 0.0)).at("error_ratio").at("mean").is_null());
}

TEST(RoundFigures, SummaryAndReportNameTheChosenRound) {
  const std::vector<RoundFigures> rounds = {round_of(0, 0.03, 0.02), round_of(1, 0.02, 0.02)};
  ImproveSettings settings;
  settings.arm.name = "an arm";
  RoundChoice choice;
  choice.best = 1;
  choice.gains = {{4, 0.01, 0.002}};
  choice.references = {0};
  const nlohmann::ordered_json summary = improve_summary(settings, rounds, choice);
  EXPECT_EQ(summary.at("best_round"), 1);
  EXPECT_FALSE(summary.at("stopped_early").get<bool>());
  EXPECT_TRUE(summary.at("rounds")[0].at("gain_cm").is_null());
  EXPECT_NEAR(summary.at("rounds")[1].at("gain_cm").at("mean").get<double>(), 1.0, kRounding);
  EXPECT_THAT(improve_report(settings, rounds, choice), HasSubstr("Round 1 is kept"));
  EXPECT_THAT(improve_curve(rounds, choice), HasSubstr("round 1, kept"));
}

}  // namespace
}  // namespace limber
