#include "limber/report/execution_report.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Environment environment_with_obstacles() {
  Environment environment;
  environment.name = "test";
  environment.obstacles = {Circle{0.1, 0.1, 0.05}, Rectangle{0.5, 0.1, 0.05, 0.1, 0.0}};
  environment.goal.theta_rad = 1.0;
  return environment;
}

ExecutionResult collided_run() {
  ExecutionResult result;
  result.frames = 80;
  result.collided = true;
  result.first_collision = Contact{1.234, {-0.001, 4, 1}};
  result.closest = Contact{1.5, {-0.012, 5, 1}};
  result.final_backbone = Backbone::Constant(3, 3, 0.25F);
  result.goal_error = {0.064, 0.21};
  result.prediction = ExecutedError{0.02, 0.05, 0.04};
  return result;
}

TEST(ExecutionReport, HoldsTheKeysThatScriptsRelyOn) {
  const nlohmann::ordered_json json = to_json(collided_run(), environment_with_obstacles());
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["collided"], true);
  EXPECT_DOUBLE_EQ(json["min_clearance_cm"].get<double>(), -1.2);
  EXPECT_DOUBLE_EQ(json["distance_to_goal_cm"].get<double>(), 6.4);
  EXPECT_DOUBLE_EQ(json["orientation_to_goal_rad"].get<double>(), 0.21);
  EXPECT_EQ(json["replans"], 0);
  EXPECT_EQ(json["frames"], 80);
  EXPECT_EQ(json["first_collision"]["obstacle"], 1);
  EXPECT_EQ(json["first_collision"]["kind"], "rectangle");
  EXPECT_EQ(json["first_collision"]["plates"], nlohmann::ordered_json({4, 5}));
  EXPECT_EQ(json["final_backbone"].size(), 3U);
  Environment without_heading = environment_with_obstacles();
  without_heading.goal.theta_rad.reset();
  EXPECT_TRUE(to_json(collided_run(), without_heading)["orientation_to_goal_rad"].is_null());
}

TEST(ExecutionReport, LeavesUnknownNumbersNull) {
  ExecutionResult result;
  result.status = ExecutionStatus::fault;
  result.message = "hose came off";
  const nlohmann::ordered_json json = to_json(result, Environment{});
  for (const char* key :
       {"min_clearance_cm", "distance_to_goal_cm", "orientation_to_goal_rad", "goal_reached",
        "collided", "first_collision", "prediction_error_cm", "final_backbone"}) {
    EXPECT_TRUE(json[key].is_null()) << key;
  }
  EXPECT_EQ(json["status"], "fault");
  EXPECT_THAT(to_text(result, Environment{}),
              AllOf(HasSubstr("fault, 0 frames"), HasSubstr("unknown")));
  EXPECT_EQ(json["message"], "hose came off");
}

TEST(ExecutionReport, KnowsOfACollisionAlsoWhereTheArmIsLostAfterIt) {
  ExecutionResult result = collided_run();
  result.final_backbone.reset();
  result.frames_not_seen = 20;
  const nlohmann::ordered_json json = to_json(result, environment_with_obstacles());
  EXPECT_EQ(json["collided"], true);
  EXPECT_TRUE(json["goal_reached"].is_null());
  EXPECT_TRUE(json["distance_to_goal_cm"].is_null());
  EXPECT_EQ(json["frames_not_seen"], 20);
  EXPECT_THAT(to_text(result, environment_with_obstacles()),
              AllOf(HasSubstr("not seen at the end"), Not(HasSubstr("from the goal"))));
}

TEST(ExecutionReport, TellsPeopleWhereItCollided) {
  const std::string text = to_text(collided_run(), environment_with_obstacles());
  EXPECT_THAT(text, HasSubstr("6.4 cm and 0.21 rad from the goal: not reached"));
  EXPECT_THAT(text, HasSubstr("collided with obstacle 1 (rectangle), plates 4 and 5, 1.23 s"));
  EXPECT_THAT(text, HasSubstr("deepest 1.2 cm at obstacle 1 (rectangle), plates 5 and 6, 1.50 s"));
  EXPECT_THAT(text, Not(HasSubstr("started")));
}

}  // namespace
}  // namespace limber
