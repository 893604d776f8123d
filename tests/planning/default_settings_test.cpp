#include "src/planning/search/default_planner.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

DefaultPlannerSettings settings_of(const std::string& text) {
  return default_settings_of(PlannerName::parse(text));
}

TEST(DefaultSettings, ANameAloneHasTheDefaultsWhichAreValid) {
  const DefaultPlannerSettings bare = settings_of("default");
  const DefaultPlannerSettings defaults;
  EXPECT_NO_THROW(require_valid(bare));
  EXPECT_EQ(bare.step_size, defaults.step_size);
  EXPECT_EQ(bare.improved_plans, defaults.improved_plans);
  EXPECT_EQ(bare.improvement_queries, defaults.improvement_queries);
}

TEST(DefaultSettings, EachIsSetByItsName) {
  EXPECT_EQ(settings_of("default,step_size=0.7").step_size, 0.7);
  EXPECT_EQ(settings_of("default,goal_steering_share=0.7").goal_steering_share, 0.7);
  EXPECT_EQ(settings_of("default,shot_spread=0.7").shot_spread, 0.7);
  EXPECT_EQ(settings_of("default,goal_bias=0.7").goal_bias, 0.7);
  EXPECT_EQ(settings_of("default,goal_spread=0.7").goal_spread, 0.7);
  EXPECT_EQ(settings_of("default,goal_configurations=7").goal_configurations, 7);
  EXPECT_EQ(settings_of("default,random_parent=0.7").random_parent, 0.7);
  EXPECT_EQ(settings_of("default,cell_pressure=0.7").cell_pressure, 0.7);
  EXPECT_EQ(settings_of("default,cell_position_m=0.7").cell_position_m, 0.7);
  EXPECT_EQ(settings_of("default,cell_orientation_rad=0.7").cell_orientation_rad, 0.7);
  EXPECT_EQ(settings_of("default,max_cost_ratio=7").max_cost_ratio, 7.0);
  EXPECT_EQ(settings_of("default,improved_plans=7").improved_plans, 7);
  EXPECT_EQ(settings_of("default,improvement_queries=7").improvement_queries, 7.0);
  EXPECT_EQ(
      settings_of("default,improvement_queries_without_room=7").improvement_queries_without_room,
      7.0);
  EXPECT_EQ(settings_of("default,hold_position_m=0.7").hold_position_m, 0.7);
  EXPECT_EQ(settings_of("default,hold_orientation_rad=0.7").hold_orientation_rad, 0.7);
}

TEST(DefaultSettings, WhatIsOutOfRangeIsNamedWithItsRange) {
  DefaultPlannerSettings settings;
  settings.max_cost_ratio = 0.5;
  EXPECT_THAT([&] { require_valid(settings); },
              ThrowsMessage<InputError>(
                  HasSubstr("planner setting max_cost_ratio = 0.5; expected 1 to 1000000")));
  settings = {};
  settings.jobs = -1;
  EXPECT_THAT([&] { require_valid(settings); },
              ThrowsMessage<InputError>(HasSubstr("jobs = -1; expected 0 to 1024")));
  EXPECT_THAT([] { (void)settings_of("default,jobs=2"); },
              ThrowsMessage<InputError>(HasSubstr("planner setting jobs: the default planner has "
                                                  "step_size, goal_steering_share")));
  EXPECT_THAT([] { (void)settings_of("default,improved_plans=1.5"); },
              ThrowsMessage<InputError>(HasSubstr("improved_plans = 1.5; expected a whole")));
}

}  // namespace
}  // namespace limber
