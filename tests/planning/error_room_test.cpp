#include "limber/forward/error_room.hpp"
#include "limber/planning/planner_factory.hpp"

#include <gmock/gmock.h>

#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

ForwardModel network_with(const std::optional<PredictionError>& error) {
  const ArmDescription arm = three_segment_arm();
  CompensationModel model = play_network(arm, kPlayM);
  model.prediction_error = error;
  return {arm, model};
}

TEST(ErrorRoom, IsWhatTheModelErredBy) {
  const ErrorRoom room =
      error_room(network_with(PredictionError{40, 3.0, 0.02, 0.012, 0.007, 0.05}));
  EXPECT_EQ(room.margin_m, 0.012);
  EXPECT_EQ(room.goal_margin.position_m, 0.007);
  EXPECT_EQ(room.goal_margin.orientation_rad, 0.05);
  EXPECT_THAT(room.note, IsEmpty());
}

TEST(ErrorRoom, OfAModelThatDoesNotSayIsFiveMillimetres) {
  const ErrorRoom room = error_room(network_with(std::nullopt));
  EXPECT_EQ(room.margin_m, 0.005);
  EXPECT_EQ(room.goal_margin.position_m, 0.005);
  EXPECT_THAT(room.note, HasSubstr("0.5 cm of clearance are kept"));
}

TEST(ErrorRoom, OfTheNoLoadModelIsNone) {
  const ErrorRoom room = error_room(ForwardModel(three_segment_arm()));
  EXPECT_EQ(room.margin_m, 0.0);
  EXPECT_EQ(room.goal_margin.position_m, 0.0);
  EXPECT_THAT(room.note, HasSubstr("may collide"));
}

TEST(ErrorRoom, GivesWayToWhatIsAskedFor) {
  AskedRoom asked;
  asked.margin_m = 0.03;
  asked.goal_margin_rad = 0.0;
  const ErrorRoom room =
      error_room(network_with(PredictionError{40, 3.0, 0.02, 0.012, 0.007, 0.05}), asked);
  EXPECT_EQ(room.margin_m, 0.03);
  EXPECT_EQ(room.goal_margin.position_m, 0.007);
  EXPECT_EQ(room.goal_margin.orientation_rad, 0.0);
  EXPECT_THAT(error_room(network_with(std::nullopt), asked).note, IsEmpty());
}

PlanResult plan_inside(Setting& s, double goal_margin_m, std::uint64_t iterations = 1500) {
  PlannerLimits limits;
  limits.iterations = iterations;
  return make_planner("default")->plan({s.arm, s.model, s.environment, 0.0, {goal_margin_m, 0.0}},
                                       limits, 3);
}

TEST(GoalMargin, PlansEndThatFarInsideTheRim) {
  Setting s(false);
  EXPECT_GT(plan_inside(s, 0.0).plan->goal_distance_m, 0.0155) << "the cheapest is near the rim";
  for (const double margin_m : {0.005, 0.009}) {
    const PlanResult result = plan_inside(s, margin_m);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_LE(result.plan->goal_distance_m, 0.02 - margin_m);
    EXPECT_THAT(result.warnings, IsEmpty());
    expect_lawful(s, *result.plan);
  }
}

TEST(GoalMargin, WhereTheGoalIsSmallerItsCentreIsAimedAt) {
  Setting s(false);
  const PlanResult result = plan_inside(s, 0.05, 4000);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LE(result.plan->goal_distance_m, 0.1 * 0.02 + 1e-4);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_THAT(result.warnings[0],
              HasSubstr("2.00 cm leaves little room for the model's error, 5.00"));
}

}  // namespace
}  // namespace limber
