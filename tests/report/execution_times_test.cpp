#include "limber/report/track_report.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "limber/report/motion_track.hpp"
#include "limber/run/appearing_obstacle.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kLag_s = 0.1;

TEST(ExecutionTimes, ShowPressuresTipAndClearancePredictedAndAsTheyWere) {
  const ArmDescription arm = small_arm();
  Environment environment;
  environment.name = "a pillar";
  environment.obstacles = {Circle{0.3, 0.3, 0.02}};
  const Plan plan = bending_plan(arm, environment);
  FakeArm driver(arm, kLag_s);
  const ExecutionResult result = execute(arm, environment, plan, driver);
  const std::string svg = execution_times_picture(arm, environment, plan, result);
  for (const char* text : {"a pillar, over time", "segment 0: set point", "segment 1: predicted",
                           "segment 1: measured", "x: predicted", "y: the arm", "clearance [cm]",
                           "contact", "</svg>"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

TEST(ExecutionTimes, WithoutObstaclesThereIsNoClearance) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  FakeArm driver(arm, kLag_s);
  const ExecutionResult result = execute(arm, environment, plan, driver);
  const std::string svg = execution_times_picture(arm, environment, plan, result);
  EXPECT_THAT(svg, HasSubstr("y: the arm"));
  EXPECT_THAT(svg, Not(HasSubstr("clearance")));
}

// Of a run that goes on after its plan, too.
TEST(ExecutionTimes, PressuresAreThoseOfTheRun) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  Plan plan = bending_plan(arm, environment);
  FakeArm driver(arm, kLag_s);
  const ExecutionResult result = execute(arm, environment, plan, driver);
  const std::string whole = execution_pressures_picture(arm, plan, result);
  EXPECT_THAT(whole, HasSubstr("segment 0: set point"));
  EXPECT_THAT(whole, HasSubstr("segment 1: measured"));
  plan.frames.resize(2);
  const auto drawn = [](const std::string& svg) { return std::ranges::count(svg, ','); };
  const std::string cut = execution_pressures_picture(arm, plan, result);
  EXPECT_GT(drawn(cut), drawn(whole) / 2) << "set points and what was measured are still there";
}

TEST(ExecutionTimes, ARunThatNobodySawHasNoTip) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  FakeFaults blind;
  blind.drop_every = 1;
  FakeArm driver(arm, kLag_s, blind);
  const ExecutionResult result = execute(arm, environment, plan, driver);
  const std::string svg = execution_times_picture(arm, environment, plan, result);
  EXPECT_THAT(svg, HasSubstr("segment 0: predicted"));
  EXPECT_THAT(svg, Not(HasSubstr("y: the arm")));
}

TEST(ExecutionTimes, WhereNobodySawTheArmThereIsNeitherTipNorClearance) {
  const ArmDescription arm = small_arm();
  Environment environment;
  environment.obstacles = {Circle{0.3, 0.3, 0.02}};
  const Plan plan = bending_plan(arm, environment);
  FakeFaults faults;
  faults.drop_every = 4;
  FakeArm driver(arm, kLag_s, faults);
  const ExecutionResult result = execute(arm, environment, plan, driver);
  const nlohmann::ordered_json track = executed_track("arm", arm, environment, result).json();
  const auto& clearances_m = track["clearances_m"];
  ASSERT_EQ(static_cast<int>(clearances_m.size()), result.episode.frame_count());
  int unseen = 0;
  for (int t = 0; t < result.episode.frame_count(); ++t) {
    const bool is_seen = result.episode.was_tracked(t);
    EXPECT_EQ(clearances_m[static_cast<std::size_t>(t)].is_null(), !is_seen) << "frame " << t;
    unseen += is_seen ? 0 : 1;
  }
  EXPECT_GT(unseen, 0);
  EXPECT_THAT(execution_times_picture(arm, environment, plan, result),
              HasSubstr("not drawn: not finite"));
}

TEST(ExecutionTimes, ClearanceFallsWhenAnObstacleAppears) {
  const ArmDescription arm = small_arm();
  const Environment environment;
  const Plan plan = bending_plan(arm, environment);
  const AppearingObstacle obstacle{5, {Circle{0.2, 0.2, 0.02}}};
  ExecutionSettings settings;
  settings.obstacle = &obstacle;
  FakeArm driver(arm, kLag_s);
  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  ASSERT_TRUE(result.appeared);
  // Before it, there is no obstacle and so nothing to draw.
  EXPECT_THAT(execution_times_picture(arm, environment, plan, result), HasSubstr("clearance [cm]"));
}

}  // namespace
}  // namespace limber
