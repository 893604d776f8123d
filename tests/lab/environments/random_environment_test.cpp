#include "limber/lab/witnessed_environment.hpp"

#include <gtest/gtest.h>

#include "limber/common/yaml_reader.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/lab/environment_measures.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/world/collision.hpp"
#include "planning/play_model.hpp"

namespace limber {
namespace {

TEST(RandomEnvironment, KeepsItsRules) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm, play_network(arm, 0.01F));
  const RandomEnvironmentSettings settings;
  for (std::uint64_t number = 1; number <= 8; ++number) {
    const auto drawn = random_environment(arm, model, 11, number);
    ASSERT_TRUE(drawn) << number;
    const Environment& e = drawn->environment;
    EXPECT_GE(e.obstacles.size(), 2U);
    EXPECT_LE(e.obstacles.size(), 5U);
    EXPECT_EQ(e.goal.position_tolerance_m, 0.02);
    const PlanningProblem problem{arm, model, e};
    const CollisionChecker checker(arm, e.obstacles);
    EXPECT_FALSE(check_problem(problem, checker, 1).refusal) << number;
    EXPECT_TRUE(straight_line_collides(problem, drawn->witness_kpa.back())) << number;
    EXPECT_FALSE(straight_line_solves(problem, {drawn->witness_kpa.back()}, 20, 99)) << number;

    MotionSimulator simulator(arm, model, checker);
    const ArmStart rest = start_state(e, arm);
    std::vector<PlanFrame> frames{{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
    for (std::size_t k = 1; k < drawn->witness_kpa.size(); ++k) {
      simulator.append_motion(drawn->witness_kpa[k], frames);
    }
    simulator.append_hold(frames);
    for (std::size_t k = 1; k < frames.size(); ++k) {
      EXPECT_GE(checker.motion_clearance(frames[k - 1].backbone, frames[k].backbone).value_m,
                settings.clearance_m - CollisionChecker::kToleranceM);
    }
    EXPECT_TRUE(is_within(e.goal, pose_error(e.goal, tip_pose(frames.back().backbone))));

    const std::string text = environment_to_yaml(e);
    EXPECT_EQ(environment_to_yaml(read_environment(YamlReader::from_text(text, "e"), arm)), text);
  }
}

TEST(RandomEnvironment, DependsOnSeedAndNumberAlone) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm);
  const auto hash = [&](std::uint64_t seed, std::uint64_t number) {
    return environment_hash(random_environment(arm, model, seed, number)->environment);
  };
  EXPECT_EQ(hash(1, 3), hash(1, 3));
  EXPECT_NE(hash(1, 3), hash(1, 4));
  EXPECT_NE(hash(1, 3), hash(2, 3));
}

TEST(RandomEnvironment, SaysWhereThereIsNone) {
  const ArmDescription arm = three_segment_arm();
  RandomEnvironmentSettings impossible;
  impossible.clearance_m = 5.0;
  impossible.attempts = 2;
  const ForwardModel model(arm);
  EXPECT_FALSE(random_environment(arm, model, 1, 1, impossible));
}

}  // namespace
}  // namespace limber
