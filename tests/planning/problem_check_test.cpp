#include "limber/planning/problem_check.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr std::uint64_t kSeed = 1;

class ProblemChecks : public ::testing::Test {
 protected:
  CollisionChecker checker() const {
    return {setting_.arm, setting_.environment.obstacles, problem_.margin_m};
  }
  std::optional<PlanStatus> refusal() const { return find_refusal(problem_, checker()).refusal; }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
};

TEST_F(ProblemChecks, AGoodProblemPasses) {
  const ProblemCheck check = check_problem(problem_, checker(), kSeed);
  EXPECT_FALSE(check.refusal);
  EXPECT_EQ(check.reason, "");
  EXPECT_THAT(check.warnings, IsEmpty());
}

// The arm is 0.705 m long: refused exactly where the whole disc lies beyond that.
TEST_F(ProblemChecks, AGoalIsOutOfReachWhereItsDiscIs) {
  setting_.environment.obstacles.clear();
  for (double x_m = 0.66; x_m < 0.78; x_m += 0.005) {
    setting_.environment.goal = {x_m, 0.0, std::nullopt, 0.02, 0.3};
    EXPECT_EQ(refusal().has_value(), x_m > setting_.arm.length_m() + 0.02) << x_m;
  }
  EXPECT_EQ(refusal(), PlanStatus::goal_unreachable);
}

TEST_F(ProblemChecks, AGoalInMillimetresIsAskedFor) {
  setting_.environment.obstacles.clear();
  setting_.environment.goal = {120.0, 400.0, std::nullopt, 0.02, 0.3};
  const ProblemCheck check = check_problem(problem_, checker(), kSeed);
  EXPECT_EQ(check.refusal, PlanStatus::goal_unreachable);
  EXPECT_THAT(check.reason,
              AllOf(HasSubstr("goal.x_m = 120 and goal.y_m = 400 are 417.612 m"),
                    HasSubstr("the arm is 0.705 m long"), HasSubstr("Is it in millimetres?")));
  setting_.environment.goal.x_m = 6.0;
  setting_.environment.goal.y_m = 0.0;
  EXPECT_THAT(check_problem(problem_, checker(), kSeed).reason,
              HasSubstr("beyond the arm's reach: 600.0 cm from the base"));
}

// By looking at many points of the disc, and at how far the tip's thickness reaches from them.
TEST_F(ProblemChecks, AGoalIsInCollisionWhereNoPointOfItsDiscIsFree) {
  const double tip_radius_m = checker().radius_m(setting_.arm.point_count() - 2);
  RandomStream random(2, 1);
  int refused = 0;
  for (int k = 0; k < 200; ++k) {
    PoseGoal& goal = setting_.environment.goal;
    goal = {random.uniform(0.2, 0.4), random.uniform(0.3, 0.5), std::nullopt, 0.02, 0.3};
    const double x_m = goal.x_m + random.uniform(-0.06, 0.06);
    const double y_m = goal.y_m + random.uniform(-0.06, 0.06);
    setting_.environment.obstacles = {
        k % 2 == 0 ? Obstacle(Circle{x_m, y_m, random.uniform(0.01, 0.06)})
                   : Obstacle(Rectangle{x_m, y_m, random.uniform(0.01, 0.1),
                                        random.uniform(0.01, 0.1), random.uniform(-4.0, 4.0)})};
    double farthest_m = -1.0;
    for (int i = 0; i < 160; ++i) {
      const double angle = 2.0 * M_PI * (i % 32) / 32.0;
      const double radius = goal.position_tolerance_m * (i / 32) / 4.0;
      farthest_m =
          std::max(farthest_m, oracle::signed_distance(setting_.environment.obstacles[0],
                                                       {goal.x_m + radius * std::cos(angle),
                                                        goal.y_m + radius * std::sin(angle)}));
    }
    const ProblemCheck check = find_refusal(problem_, checker());
    if (check.refusal == PlanStatus::goal_in_collision) {
      ++refused;
      EXPECT_LE(farthest_m, tip_radius_m + 1e-9) << "only what is certain is refused";
    }
  }
  EXPECT_GT(refused, 10);
  EXPECT_LT(refused, 190);
}

// Where a plate has not moved far it has only a part of its tube.
TEST_F(ProblemChecks, OfATubeThatGrowsTheTipHasAPartNearItsStart) {
  const auto plates = static_cast<std::size_t>(setting_.arm.point_count());
  setting_.environment.goal = {0.6, 0.2, std::nullopt, 0.02, 0.3};
  setting_.environment.obstacles = {Circle{0.6, 0.3, 0.02}};  // 8 cm from the goal
  PlanTube tube;
  tube.plate_radius_m.assign(plates, 0.1);
  problem_.tube = tube;
  EXPECT_EQ(find_refusal(problem_, checker_of(problem_)).refusal, PlanStatus::goal_in_collision);
  problem_.tube->growth = {0.1, 10.0};
  EXPECT_FALSE(find_refusal(problem_, checker_of(problem_)).refusal);
  setting_.environment.obstacles = {Circle{0.6, 0.22, 0.02}};  // at whose rim it is
  EXPECT_EQ(find_refusal(problem_, checker_of(problem_)).refusal, PlanStatus::goal_in_collision);
}

// Its first set points are a plan's first.
TEST_F(ProblemChecks, AStartBeyondTheArmsOwnLimitsIsRefused) {
  setting_.environment.start = start_state(setting_.environment, setting_.arm);
  setting_.environment.start->setpoints_kpa = {Pressures::Constant(3, 100.0F)};
  EXPECT_FALSE(refusal());
  setting_.environment.start->setpoints_kpa[0][1] = 101.0F;
  EXPECT_EQ(refusal(), PlanStatus::invalid_start);
}

TEST_F(ProblemChecks, TheMarginCountsAtStartAndGoalAndIsNamed) {
  setting_.environment.obstacles = {Circle{0.3, 0.06, 0.02}};
  EXPECT_FALSE(refusal());
  problem_.margin_m = 0.02;
  const ProblemCheck check = find_refusal(problem_, checker());
  EXPECT_EQ(check.refusal, PlanStatus::invalid_start);
  EXPECT_THAT(check.reason,
              AllOf(HasSubstr("cm deep in obstacle 0 (circle)"), HasSubstr("plates"),
                    HasSubstr("(margin of 2.00 cm included): move the obstacle or the start")));
}

TEST_F(ProblemChecks, WhatTheNoLoadModelDoesNotReachIsAWarningAlone) {
  setting_.environment.obstacles.clear();
  setting_.environment.goal = {-0.6, 0.0, std::nullopt, 0.02, 0.3};
  EXPECT_FALSE(refusal());
  const std::vector<std::string> warnings = find_warnings(problem_, kSeed);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("the no-load model reaches no closer to the goal than"));
  EXPECT_EQ(find_warnings(problem_, kSeed), warnings) << "the seed decides";
}

TEST_F(ProblemChecks, ExplainsAGoalThatIsReachedOnlyInCollision) {
  EXPECT_EQ(reached_only_in_collision(problem_, checker(), kSeed), "") << "some way is free";
  // Walls on both sides of the goal, nearer than the arm is thick before its tip.
  setting_.environment.obstacles = {Rectangle{0.15, 0.2, 0.5, 0.02, 0.0},
                                    Rectangle{0.5, 0.2, 0.1, 0.02, 0.0},
                                    Rectangle{0.55, 0.4, 0.02, 0.5, 0.0}};
  EXPECT_FALSE(refusal());
  EXPECT_THAT(reached_only_in_collision(problem_, checker(), kSeed),
              AllOf(HasSubstr("reaches the goal only in collision: of "),
                    HasSubstr("configurations the least deep is"), HasSubstr("(rectangle)")));
  EXPECT_EQ(reached_only_in_collision(problem_, checker(), kSeed, [] { return true; }), "");
  setting_.environment.goal = {-0.6, 0.0, std::nullopt, 0.02, 0.3};
  EXPECT_EQ(reached_only_in_collision(problem_, checker(), kSeed), "") << "a warning says it";
}

// A program's own arm may turn a gap by more than half a turn. That is no shape, and here is no
// obstacle to name.
TEST_F(ProblemChecks, WhatIsNoShapeIsReachedInNoCollision) {
  ArmDescription arm = setting_.arm;
  arm.command = {"angle", "rad"};
  arm.no_load = NoLoadKind::curvature;
  Segment segment;
  segment.length_m = 0.2;
  segment.width_m = 0.02;
  segment.gaps = 1;
  segment.pressure_limit_kpa = 25.0;
  arm.segments = {segment};
  const ForwardModel model(arm);
  Environment environment;
  constexpr double kTurnRad = 4.0;
  environment.goal = {0.2 * std::sin(kTurnRad) / kTurnRad,
                      0.2 * (1.0 - std::cos(kTurnRad)) / kTurnRad, std::nullopt, 0.002, 0.3};
  EXPECT_EQ(reached_only_in_collision({arm, model, environment}, CollisionChecker(arm, {}), kSeed),
            "");
}

TEST_F(ProblemChecks, MarginsAreDistances) {
  EXPECT_NO_THROW(require_margin(0.0));
  EXPECT_NO_THROW(require_margin(kMaxMarginM));
  EXPECT_THAT([] { require_margin(-1e-9); },
              ThrowsMessage<InputError>(HasSubstr("margin_m = -1e-09; expected a distance")));
  EXPECT_NO_THROW(require_goal_margin({0.01, 0.1}));
  EXPECT_THAT(
      [] {
        require_goal_margin({0.0, std::numeric_limits<double>::quiet_NaN()});
      },
      ThrowsMessage<InputError>(HasSubstr("goal margin of nan; expected a number, 0 to")));
}

}  // namespace
}  // namespace limber
