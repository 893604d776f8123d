#include "src/studio/scene_json.hpp"

#include <gmock/gmock.h>

#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/report/scene_json.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

ArmDescription own_arm() {
  return load_arm(data_folder() / "arms/three_segment.yaml");
}

TEST(SceneJson, EveryEnvironmentSurvivesTheWayToThePageAndBack) {
  const ArmDescription arm = own_arm();
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(data_folder() / "environments")) {
    if (file.path().extension() != ".yaml") {
      continue;
    }
    const Environment environment = load_environment(file.path(), arm);
    const auto sent = nlohmann::json::parse(environment_to_json(environment).dump());
    const Environment back = environment_from_json(sent, arm);
    EXPECT_EQ(environment_to_yaml(back), environment_to_yaml(environment)) << file.path();
    ++count;
  }
  EXPECT_EQ(count, 8);
}

TEST(SceneJson, AMeasuredStartSurvivesToo) {
  const ArmDescription arm = own_arm();
  Environment environment;
  environment.name = "in \"motion\"";
  environment.goal = {0.3, 0.3, 0.1F, 0.02, 0.3};
  environment.start = start_state(Environment(), arm);
  environment.start->before = environment.start->backbone;
  environment.start->setpoints_kpa = {Pressures::Constant(3, 0.1F), Pressures::Zero(3)};
  const auto sent = nlohmann::json::parse(environment_to_json(environment).dump());
  EXPECT_EQ(environment_to_yaml(environment_from_json(sent, arm)),
            environment_to_yaml(environment));
}

TEST(SceneJson, WhatAFileMayNotHoldARequestMayNotEither) {
  const ArmDescription arm = own_arm();
  nlohmann::json json = {{"name", "x"},
                         {"obstacles", {{{"circle", {{"x_m", 1}, {"y_m", 1}, {"radius_m", -1}}}}}},
                         {"start", "rest"},
                         {"goal", {{"x_m", 0.3}, {"y_m", 0.3}, {"position_tolerance_m", 0.02}}}};
  EXPECT_THAT([&] { (void)environment_from_json(json, arm); },
              ThrowsMessage<InputError>(HasSubstr("radius_m")));
  EXPECT_THAT([&] { (void)environment_from_json(nlohmann::json::array(), arm); },
              ThrowsMessage<InputError>(HasSubstr("expected an object")));
}

TEST(SceneJson, TheReachIsThatOfTheUnloadedArm) {
  const ArmDescription arm = own_arm();
  const nlohmann::ordered_json reach = reach_to_json(arm);
  const auto middles = reach["middles_m"].get<std::vector<double>>();
  const double cell_m = reach["cell_m"];
  ASSERT_GT(middles.size(), 200U);
  for (std::size_t i = 0; i < middles.size(); i += 2) {
    EXPECT_LE(std::hypot(middles[i], middles[i + 1]), arm.length_m() + cell_m);
  }
}

TEST(SceneJson, AnArmWithoutPressureOnOneSideReachesWhereItRests) {
  ArmDescription arm = own_arm();
  for (Segment& segment : arm.segments) {
    segment.pressure_limit_kpa = PressureLimits(0.0, segment.pressure_limit_kpa.upper_kpa);
  }
  const nlohmann::ordered_json reach = reach_to_json(arm);
  const auto middles = reach["middles_m"].get<std::vector<double>>();
  double nearest_m = arm.length_m();
  for (std::size_t i = 0; i < middles.size(); i += 2) {
    nearest_m = std::min(nearest_m, std::hypot(middles[i] - arm.length_m(), middles[i + 1]));
  }
  EXPECT_LT(nearest_m, double(reach["cell_m"]));
}

}  // namespace
}  // namespace limber
