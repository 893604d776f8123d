#include "limber/training/unseen_error.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "limber/common/statistics.hpp"
#include "limber/data/valve_simulation.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kMicrometre = 1e-6;  // [m], [rad]; float32 along a run, side by side or alone

CompensationModel model_with_valves(const ArmDescription& arm, bool reads_velocity = false) {
  CompensationModel model = untrained_model(arm, BackboneLayout::gap_poses, {8}, 1,
                                            OutputForm::compensation, reads_velocity);
  const SegmentValves valves{{0.1, 80.0}, {0.3, 80.0}, 0.07, 0.2};
  model.valves = ValveParameters{true, {valves, valves, valves}};
  return model;
}

struct ErrorByHand {
  double max_m = 0.0;
  double off_path_m = 0.0;
  double end_m = 0.0;
  double end_rad = 0.0;
};

double apart_m(const Backbone& a, const Backbone& b) {
  return double((a - b).leftCols<2>().rowwise().norm().maxCoeff());
}

/// From a shape to the nearest predicted within eight frames of frame k, quarters between them too.
double off_path_by_hand_m(const std::vector<Backbone>& predicted, const Backbone& seen, int k) {
  const int count = static_cast<int>(predicted.size()) - 1;
  double nearest = 1e9;
  for (int quarter = 4 * std::max(0, k - 8); quarter <= 4 * std::min(count, k + 8); ++quarter) {
    const auto before = static_cast<std::size_t>(quarter / 4);
    const std::size_t after = std::min(before + 1, predicted.size() - 1);
    const float f = 0.25F * float(quarter % 4);
    nearest =
        std::min(nearest, apart_m((1.0F - f) * predicted[before] + f * predicted[after], seen));
  }
  return nearest;
}

/// One run, frame by frame, with an arm of one query.
ErrorByHand error_by_hand(const ArmDescription& arm, const CompensationModel& compensation,
                          const Episode& episode, int first, int count) {
  const ForwardModel model(arm, compensation);
  ForwardModel::Workspace workspace;
  const FrameMatrix kpa =
      simulate_valves(*compensation.valves, arm.frame_rate_hz, episode, first, count + 1);
  const auto seen = [&](int frame) {
    Backbone shape(arm.point_count(), 3);
    shape.reshaped<Eigen::RowMajor>() = episode.backbone.row(first + frame).transpose();
    return shape;
  };
  std::vector<Backbone> predicted{seen(0)};
  Backbone before = seen(first > 0 ? -1 : 0);  // it may have moved before the run
  for (int k = 1; k <= count; ++k) {
    Backbone next(arm.point_count(), 3);
    model.step(kpa.row(k - 1).transpose(), kpa.row(k).transpose(), before, predicted.back(), next,
               workspace);
    before = predicted.back();
    predicted.push_back(next);
  }
  ErrorByHand error;
  for (int k = 1; k <= count; ++k) {
    const Backbone there = seen(k);
    error.max_m = std::max(error.max_m, apart_m(predicted[static_cast<std::size_t>(k)], there));
    error.off_path_m = std::max(error.off_path_m, off_path_by_hand_m(predicted, there, k));
  }
  const Backbone apart = predicted.back() - seen(count);
  const Eigen::Index tip = arm.point_count() - 1;
  error.end_m = double(apart.row(tip).head<2>().norm());
  error.end_rad = std::abs(double(apart(tip, 2)));
  return error;
}

class UnseenErrorByHand : public ::testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Models, UnseenErrorByHand, ::testing::Bool());

TEST_P(UnseenErrorByHand, IsThatOfMotionsFromSetPoints) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm, GetParam());
  const Episode episode = toy_episode(arm, 5, 40, 3);
  std::vector<double> largest, off_path, end, turn;
  for (int first = 0; first < 200; first += 40) {
    const ErrorByHand error = error_by_hand(arm, model, episode, first, 40);
    largest.push_back(error.max_m);
    off_path.push_back(error.off_path_m);
    end.push_back(error.end_m);
    turn.push_back(error.end_rad);
  }
  for (const int jobs : {1, 2}) {
    const auto error = measure_prediction_error(arm, model, {episode}, jobs);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->runs, 5);
    EXPECT_NEAR(error->run_s, 2.0, kMicrometre);
    // Fewer than 19 runs: usual multiples of the median.
    EXPECT_NEAR(error->max_position_m, 2.0 * median(largest), kMicrometre);
    EXPECT_NEAR(error->off_path_m, 2.0 * median(off_path), kMicrometre);
    EXPECT_NEAR(error->end_position_m, 2.6 * median(end), kMicrometre);
    EXPECT_NEAR(*error->end_orientation_rad, 5.4 * median(turn), kMicrometre);
    EXPECT_LE(error->off_path_m, error->max_position_m);
  }
  // The last motion alone, with what is known of the arm before it.
  const auto last = measure_prediction_error(arm, model, {episode}, 1, 160);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->runs, 1);
  EXPECT_NEAR(last->max_position_m, 2.0 * largest.back(), kMicrometre);
}

TEST(UnseenError, LongMotionsAreCutAndWhatStandsDoesNotCount) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  Episode episode = toy_episode(arm, 6, 40, 3);
  episode.motion_index.assign(episode.motion_index.size(), 0);
  const auto cut = measure_prediction_error(arm, model, {episode});
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->runs, 3);  // 240 frames, 5 s and the rest
  episode.setpoint_kpa.bottomRows(141).rowwise() = episode.setpoint_kpa.row(100).eval();
  const auto moving = measure_prediction_error(arm, model, {episode});
  ASSERT_TRUE(moving);
  EXPECT_EQ(moving->runs, 1);
}

// Plans begin with an arm at rest; what begins in full swing says less about them.
TEST(UnseenError, MotionsFromRestCountAloneWhereTheyAreEnough) {
  const ArmDescription arm = three_segment_arm();
  const CompensationModel model = model_with_valves(arm);
  // 60 frames a motion: the slowest takes 40 at 5 kPa a frame, then the arm stands.
  const Episode calm = toy_episode(arm, 20, 60, 3);
  const Episode hasty = toy_episode(arm, 20, 8, 4);
  const auto both = measure_prediction_error(arm, model, {calm, hasty});
  const auto alone = measure_prediction_error(arm, model, {calm});
  ASSERT_TRUE(both && alone);
  EXPECT_EQ(alone->runs, 19);  // nobody knows whether the arm stood before the first frame
  EXPECT_LE(both->runs, 20) << "of the hasty ones at most the first";
  EXPECT_EQ(measure_prediction_error(arm, model, {hasty})->runs, 20);
  Episode guessed = hasty;  // to have stood still before each motion
  guessed.tracked.assign(161, 1);
  for (int first = 8; first < 160; first += 8) {
    for (int t = first - 4; t < first; ++t) {
      guessed.tracked[static_cast<std::size_t>(t)] = 0;
      guessed.backbone.row(t) = guessed.backbone.row(first);
    }
  }
  EXPECT_EQ(measure_prediction_error(arm, model, {calm, guessed})->runs, alone->runs);
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
  EXPECT_LE(after->max_position_m, before->max_position_m);
  EXPECT_EQ(after->end_position_m, before->end_position_m);
}

TEST(UnseenError, WhatTheModelPredictsOfThemCountsAsLearnt) {
  const ArmDescription arm = three_segment_arm();
  CompensationModel model = model_with_valves(arm);
  const Episode episode = toy_episode(arm, 12, 40, 3);
  model.learnt = learnt_region_of(std::vector<Episode>{episode});
  const LearntRegion before = *model.learnt;
  note_unseen(arm, model, {episode});
  EXPECT_EQ(model.prediction_error, measure_prediction_error(arm, model, {episode}));
  const ForwardModel forward(arm, model);
  ForwardModel::Workspace workspace;
  Backbone state(arm.point_count(), 3);
  state.reshaped<Eigen::RowMajor>() = episode.backbone.row(0).transpose();
  const FrameMatrix kpa = simulate_valves(*model.valves, arm.frame_rate_hz, episode, 0, 41);
  double most = 0.0;
  double max_before = 0.0;
  for (int k = 1; k <= 40; ++k) {
    forward.step(kpa.row(k - 1).transpose(), kpa.row(k).transpose(), state, state, workspace);
    most = std::max(most, model.learnt->novelty(kpa.row(k).transpose(), state));
    max_before = std::max(max_before, before.novelty(kpa.row(k).transpose(), state));
  }
  EXPECT_LE(most, 1.0);
  EXPECT_GT(max_before, 1.0) << "an untrained network draws shapes of its own";
}

}  // namespace
}  // namespace limber
