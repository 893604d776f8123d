// The error of a network if the pressures too are predicted, from set points.
#include <cmath>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limber/data/valve_simulation.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/evaluation.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kMicrometre_cm = 1e-4;

TEST(SetpointEvaluation, FromSetpointsIsOpenLoopWhereTheValvesAreRight) {
  const ArmDescription arm = three_segment_arm();
  const SegmentValves valves{{0.1, 80.0}, {0.3, 80.0}, 0.07, 0.2};
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {8}, 1);
  model.valves = ValveParameters{true, {valves, valves, valves}};
  Episode episode = toy_episode(arm, 6, 30, 3);
  episode.pressure_kpa = simulate_valves(*model.valves, arm.frame_rate_hz, episode);
  const auto errors = [&] {
    return *evaluate(ForwardModel(arm), std::make_unique<ForwardModel>(arm, model).get(), {episode})
                .network;
  };
  RolloutErrors right = errors();
  ASSERT_TRUE(right.open_loop_from_setpoints);
  EXPECT_NEAR(right.open_loop_from_setpoints->position_cm.mean, right.open_loop.position_cm.mean,
              kMicrometre_cm);
  model.valves->segments[0].dead_time_s = 0.5;
  EXPECT_GT(std::abs(errors().open_loop_from_setpoints->position_cm.mean -
                     right.open_loop.position_cm.mean),
            100.0 * kMicrometre_cm);
  EXPECT_EQ(errors().open_loop.position_cm.mean, right.open_loop.position_cm.mean);
}

TEST(SetpointEvaluation, FromSetpointsIsNullWithoutValvesOrSetpoints) {
  const ArmDescription arm = three_segment_arm();
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {8}, 1);
  Episode episode = toy_episode(arm, 2, 30, 3);
  const auto json = [&] {
    const ForwardModel network(arm, model);
    return to_json(evaluate(ForwardModel(arm), &network, {episode}))
        .at("network")
        .at("open_loop_from_setpoints");
  };
  EXPECT_TRUE(json().is_null());
  model.valves = ValveParameters{true, std::vector<SegmentValves>(3, {{0.1, 80.0}, {0.1, 80.0}})};
  EXPECT_TRUE(json().is_object());
  episode.setpoint_kpa = episode.pressure_kpa;
  EXPECT_TRUE(json().is_null());
}

}  // namespace
}  // namespace limber
