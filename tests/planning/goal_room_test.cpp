#include "src/planning/certified/asked_problem.hpp"

#include <gmock/gmock.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class GoalRoom : public ::testing::Test {
 protected:
  GoalRoom() { setting_.environment.goal = {0.3, 0.4, 1.0, 0.02, 0.3}; }
  PoseGoal inside(const PoseError& margin) const {
    return with_room(setting_.environment, margin).goal;
  }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
};

TEST_F(GoalRoom, MarginsAndAReserveAreTakenOffTheTolerances) {
  EXPECT_NEAR(inside({0.0, 0.0}).position_tolerance_m, 0.02 - kReserveM, 1e-12);
  EXPECT_NEAR(inside({0.0, 0.0}).orientation_tolerance_rad, 0.3 - kReserveRad, 1e-12);
  EXPECT_NEAR(inside({0.012, 0.1}).position_tolerance_m, 0.008 - kReserveM, 1e-12);
  EXPECT_NEAR(inside({0.012, 0.1}).orientation_tolerance_rad, 0.2 - kReserveRad, 1e-12);
  EXPECT_EQ(inside({0.012, 0.1}).x_m, 0.3);
  EXPECT_EQ(inside({0.012, 0.1}).theta_rad, 1.0);
}

TEST_F(GoalRoom, TheReserveIsAtMostATenth) {
  setting_.environment.goal.position_tolerance_m = 1e-5;
  EXPECT_NEAR(inside({0.0, 0.0}).position_tolerance_m, 0.9e-5, 1e-12);
}

// More margin never makes the region larger, until it does not fit: then the goal is used whole,
// or nearly, and aimed at.
TEST_F(GoalRoom, WhereTheMarginDoesNotFitMostOfTheGoalIsUsed) {
  double before_m = 1.0;
  for (double margin_m = 0.0; margin_m <= 0.015; margin_m += 0.001) {
    const double tolerance_m = inside({margin_m, 0.0}).position_tolerance_m;
    EXPECT_LT(tolerance_m, before_m);
    EXPECT_GT(tolerance_m, 0.0);
    before_m = tolerance_m;
  }
  EXPECT_NEAR(inside({0.0151, 0.0}).position_tolerance_m, 0.8 * 0.02 - kReserveM, 1e-12);
  EXPECT_NEAR(inside({5.0, 0.0}).position_tolerance_m, 0.8 * 0.02 - kReserveM, 1e-12);
}

TEST_F(GoalRoom, AnErrorToKeepRoomForMakesTheInnerTenthTheAim) {
  EXPECT_FALSE(aim_of(problem_));
  problem_.goal_margin = {0.001, 0.0};
  const std::optional<PoseError> aim = aim_of(problem_);
  ASSERT_TRUE(aim);
  EXPECT_NEAR(aim->position_m, 0.002, 1e-12);
  EXPECT_NEAR(aim->orientation_rad, 0.03, 1e-12);
}

TEST_F(GoalRoom, AReasonThatNamesTheToleranceSaysWhatIsKeptOfIt) {
  setting_.environment.goal.orientation_tolerance_rad = 0.002;  // which no first round meets
  problem_.goal_margin = {0.01, 0.0};
  PlannerLimits limits;
  limits.iterations = 1;
  const PlanResult result = make_planner("default")->plan(problem_, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::limit);
  EXPECT_THAT(result.reason, HasSubstr("(tolerance 1.0 cm)"));
  EXPECT_THAT(result.reason, HasSubstr("; 1.01 cm of the tolerance are kept for the model's"));
}

// Nearer than the searches' reserve: nothing that the goal's tolerances could change.
TEST_F(GoalRoom, IsNotToBlameForAStartBesideAnObstacle) {
  problem_.goal_margin = {0.01, 0.0};
  setting_.environment.obstacles = {Circle{0.3, 0.1, 0.02}};
  const double away_m = checker_of(problem_).clearance(start_of(problem_).backbone).value_m;
  setting_.environment.obstacles = {Circle{0.3, 0.1 - away_m + 1.5e-4, 0.02}};
  PlannerLimits limits;
  limits.iterations = 1;
  const PlanResult result = make_planner("default")->plan(problem_, limits, 3);
  EXPECT_EQ(result.status, PlanStatus::invalid_start);
  EXPECT_THAT(result.reason, Not(HasSubstr("--goal-margin-m")));
}

TEST_F(GoalRoom, TellsWhetherThereIsRoomAndWarnsWhereNot) {
  problem_.goal_margin = {0.015, 0.2};
  EXPECT_TRUE(has_room(problem_));
  EXPECT_THAT(warnings_of_aim(problem_), IsEmpty());
  problem_.goal_margin = {0.016, 0.25};
  EXPECT_FALSE(has_room(problem_));
  const std::vector<std::string> warnings = warnings_of_aim(problem_);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_THAT(warnings[0], HasSubstr("2.00 cm leaves little room for the model's error, 1.60 cm"));
  EXPECT_THAT(warnings[1], HasSubstr("0.300 rad leaves little room for the model's error, 0.250"));
  setting_.environment.goal.theta_rad.reset();
  EXPECT_EQ(warnings_of_aim(problem_).size(), 1U) << "any heading will do";
  problem_.goal_margin = {0.0, 0.25};
  EXPECT_TRUE(has_room(problem_));
}

}  // namespace
}  // namespace limber
