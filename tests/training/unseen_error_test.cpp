#include "limber/training/unseen_error.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limber/data/valve_simulation.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kMicrometre = 1e-6;  // [m], [rad]; float32 along 200 frames, side by side or alone
constexpr int kRunFrames = 200;       // 10 s at 20 Hz

CompensationModel model_with_valves(const ArmDescription& arm) {
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {8}, 1);
  const SegmentValves valves{{0.1, 80.0}, {0.3, 80.0}, 0.07, 0.2};
  model.valves = ValveParameters{true, {valves, valves, valves}};
  return model;
}

/// Run by run, frame by frame, with an arm of one query.
PredictionError error_by_hand(const ArmDescription& arm, const CompensationModel& compensation,
                              const Episode& episode) {
  const ForwardModel model(arm, compensation);
  ForwardModel::Workspace workspace;
  std::vector<double> largest, end, turn;
  for (int first = 0; first + kRunFrames < episode.frame_count(); first += kRunFrames) {
    const FrameMatrix kpa =
        simulate_valves(*compensation.valves, arm.frame_rate_hz, episode, first, kRunFrames + 1);
    Backbone state(arm.point_count(), 3);
    state.reshaped<Eigen::RowMajor>() = episode.backbone.row(first).transpose();
    double worst = 0.0;
    Eigen::Index tip = 3 * (arm.point_count() - 1);
    for (int k = 1; k <= kRunFrames; ++k) {
      model.step(kpa.row(k - 1).transpose(), kpa.row(k).transpose(), state, state, workspace);
      for (int j = 0; j < arm.point_count(); ++j) {
        worst = std::max(worst,
                         std::hypot(double(state(j, 0) - episode.backbone(first + k, 3 * j)),
                                    double(state(j, 1) - episode.backbone(first + k, 3 * j + 1))));
      }
    }
    const auto last = episode.backbone.row(first + kRunFrames);
    const auto at = state.row(arm.point_count() - 1);
    largest.push_back(worst);
    end.push_back(std::hypot(double(at[0] - last[tip]), double(at[1] - last[tip + 1])));
    turn.push_back(std::abs(double(at[2] - last[tip + 2])));
  }
  // Fewer than 19 runs: the largest.
  return {static_cast<int>(largest.size()), 10.0, *std::ranges::max_element(largest),
          *std::ranges::max_element(end), *std::ranges::max_element(turn)};
}

TEST(UnseenError, IsThatOfRunsFromSetPoints) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  const Episode episode = toy_episode(arm, 23, 30, 3);  // 691 frames: three runs, 90 left over
  const PredictionError expected = error_by_hand(arm, model, episode);
  for (const int jobs : {1, 2}) {
    const auto error = measure_prediction_error(arm, model, {episode}, jobs);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->runs, 3);
    EXPECT_EQ(error->runs, expected.runs);
    EXPECT_NEAR(error->run_s, 10.0, kMicrometre);
    EXPECT_NEAR(error->largest_position_m, expected.largest_position_m, kMicrometre);
    EXPECT_NEAR(error->end_position_m, expected.end_position_m, kMicrometre);
    EXPECT_NEAR(error->end_orientation_rad, expected.end_orientation_rad, kMicrometre);
  }
}

TEST(UnseenError, RunsAreShorterWhereEpisodesAre) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  const auto error = measure_prediction_error(
      arm, model,
      {toy_episode(arm, 1, 40, 1), toy_episode(arm, 2, 40, 2), toy_episode(arm, 4, 40, 3)});
  ASSERT_TRUE(error);
  EXPECT_NEAR(error->run_s, 4.0, kMicrometre);  // the median, 80 frames
  EXPECT_EQ(error->runs, 3);                    // one of 80 frames, two of 160
}

TEST(UnseenError, IsNoneWhereNothingWasSeen) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  EXPECT_FALSE(measure_prediction_error(arm, model, {}));
  Episode episode = toy_episode(arm, 2, 40, 1);
  episode.tracked.assign(81, 0);
  EXPECT_FALSE(measure_prediction_error(arm, model, {episode}));
}

// A frame that was filled in by a guess says nothing of the model, however wrong the guess.
TEST(UnseenError, FramesThatWereNotSeenDoNotCount) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  Episode episode = toy_episode(arm, 5, 40, 1);
  const auto before = measure_prediction_error(arm, model, {episode});
  episode.tracked.assign(201, 1);
  episode.tracked[100] = 0;
  episode.backbone.row(100).array() += 5.0F;
  const auto after = measure_prediction_error(arm, model, {episode});
  ASSERT_TRUE(before && after);
  EXPECT_LE(after->largest_position_m, before->largest_position_m);
  EXPECT_EQ(after->end_position_m, before->end_position_m);
}

}  // namespace
}  // namespace limber
