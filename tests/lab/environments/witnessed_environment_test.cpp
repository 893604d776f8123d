#include "limber/lab/witnessed_environment.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "limber/common/yaml_reader.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/world/collision.hpp"
#include "planning/play_model.hpp"

namespace limber {
namespace {

constexpr double kNearM = 0.16;
constexpr double kEndM = 1e-3;  // the arm creeps on where its hold is a frame longer

/// The witness's motion as a plan whose predictions are worth nothing.
Plan plan_of(const ArmDescription& arm, const ForwardModel& model,
             const WitnessedEnvironment& drawn) {
  const CollisionChecker checker(arm, drawn.environment.obstacles);
  MotionSimulator simulator(arm, model, checker);
  std::vector<Pressures> waypoints = {start_state(drawn.environment, arm).pressures_kpa};
  waypoints.insert(waypoints.end(), drawn.waypoints_kpa.begin(), drawn.waypoints_kpa.end());
  return build_plan({arm, model, drawn.environment}, simulator, waypoints, "witness", 0);
}

// The executor judges at every simulator step: an oracle that knows nothing of the generator.
TEST(WitnessedEnvironment, IsSolvedByTheArmThatWasItsWitness) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  std::set<std::string> kinds;
  std::set<double> clearances;
  std::set<std::size_t> motions;
  for (std::uint64_t number = 1; number <= 12; ++number) {
    const auto drawn = witnessed_environment(arm, virtual_witness(arm), 11, number);
    ASSERT_TRUE(drawn) << number;
    const Environment& e = drawn->environment;
    VirtualArm driver(arm);
    const ExecutionResult run = execute(arm, e, plan_of(arm, no_load, *drawn), driver);
    EXPECT_LT(run.goal_error.position_m, kEndM) << number;
    EXPECT_TRUE(run.goal_reached) << number;
    EXPECT_GE(run.closest->clearance.value_m, drawn->clearance_m - CollisionChecker::kToleranceM);
    EXPECT_GE(e.obstacles.size(), 5U);
    EXPECT_LE(e.obstacles.size(), 13U);
    EXPECT_GE(std::hypot(e.goal.x_m - arm.length_m(), e.goal.y_m), 0.15 - kEndM) << "it moves";
    const CollisionChecker checker(arm, e.obstacles);
    EXPECT_FALSE(check_problem({arm, no_load, e}, checker, 1).refusal) << number;
    clearances.insert(std::round(1e6 * drawn->clearance_m) / 1e6);
    motions.insert(drawn->waypoints_kpa.size());
    for (const Obstacle& obstacle : e.obstacles) {
      kinds.insert(obstacle_kind(obstacle));
    }
    const std::string text = environment_to_yaml(e);
    EXPECT_EQ(environment_to_yaml(read_environment(YamlReader::from_text(text, "e"), arm)), text);
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"circle", "rectangle", "polygon"}));
  EXPECT_EQ(clearances, (std::set<double>{0.012, 0.02}));
  EXPECT_EQ(motions, (std::set<std::size_t>{1, 2, 3}));
}

TEST(WitnessedEnvironment, HasEveryObstacleNearTheMotion) {
  const ArmDescription arm = three_segment_arm();
  const auto drawn = witnessed_environment(arm, virtual_witness(arm), 3, 1);
  ASSERT_TRUE(drawn);
  const std::vector<Backbone> shapes = virtual_witness(arm)(drawn->waypoints_kpa);
  for (const Obstacle& obstacle : drawn->environment.obstacles) {
    const CollisionChecker checker(arm, {obstacle});
    double closest_m = 1.0;
    for (const Backbone& shape : shapes) {
      closest_m = std::min(closest_m, checker.clearance(shape).value_m);
    }
    EXPECT_LE(closest_m, kNearM);
    EXPECT_GE(closest_m, drawn->clearance_m - CollisionChecker::kToleranceM);
  }
}

TEST(WitnessedEnvironment, DependsOnSeedAndNumberAlone) {
  const ArmDescription arm = three_segment_arm();
  const auto hash = [&](std::uint64_t seed, std::uint64_t number) {
    return environment_hash(
        witnessed_environment(arm, virtual_witness(arm), seed, number)->environment);
  };
  EXPECT_EQ(hash(1, 3), hash(1, 3));
  EXPECT_NE(hash(1, 3), hash(1, 4));
  EXPECT_NE(hash(1, 3), hash(2, 3));
}

TEST(WitnessedEnvironment, GrowsWithTheArm) {
  const ArmDescription paper = three_segment_arm();
  ArmDescription half = paper;
  for (Segment& segment : half.segments) {
    segment.length_m *= 0.5;
  }
  const ForwardModel of_paper(paper);
  const ForwardModel of_half(half);
  const auto large = witnessed_environment(paper, model_witness(paper, of_paper), 5, 2);
  const auto small = witnessed_environment(half, model_witness(half, of_half), 5, 2);
  ASSERT_TRUE(large && small);
  EXPECT_DOUBLE_EQ(small->clearance_m, 0.5 * large->clearance_m);
}

TEST(WitnessedEnvironment, IsOfTheModelWhereThatMoves) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm, play_network(arm, 0.01F));
  const auto drawn = witnessed_environment(arm, model_witness(arm, model), 11, 1);
  ASSERT_TRUE(drawn);
  const Plan plan = plan_of(arm, model, *drawn);
  EXPECT_LT(plan.goal_distance_m, kEndM);
  EXPECT_GE(plan.clearance_m, drawn->clearance_m - CollisionChecker::kToleranceM);
}

TEST(WitnessedEnvironment, SaysWhereThereIsNone) {
  const ArmDescription arm = three_segment_arm();
  const Backbone rest = start_state(Environment{}, arm).backbone;
  const Witness stays = [&](const std::vector<Pressures>&) { return std::vector{rest, rest}; };
  EXPECT_FALSE(witnessed_environment(arm, stays, 1, 1));
}

}  // namespace
}  // namespace limber
