#include "limber/training/evaluation.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/gap_bounds_fit.hpp"
#include "src/training/rollout.hpp"
#include "support/exit_interrupted.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kMicrometre_cm = 1e-4;
// A hundred additions of float32 in base poses of half a metre.
constexpr double kDriftRounding_cm = 1e-3;

/// A network of zero weights: (5) with Φ = 0, the no-load model itself.
CompensationModel zero_network(const ArmDescription& arm) {
  CompensationModel model;
  model.layout = BackboneLayout::base_poses;
  const int size = 3 * arm.point_count();
  const int inputs = 2 * arm.segment_count() + 2 * size;
  model.layers = {{Eigen::MatrixXf::Zero(size, inputs), Eigen::VectorXf::Zero(size)}};
  model.input = {Eigen::VectorXf::Zero(inputs), Eigen::VectorXf::Ones(inputs)};
  model.output = {Eigen::VectorXf::Zero(size), Eigen::VectorXf::Ones(size)};
  model.arm_name = arm.name;
  model.arm_hash = arm.hash();
  model.segment_count = arm.segment_count();
  model.point_count = arm.point_count();
  model.preset = "paper";
  return model;
}

/// A network that reads B̃ and B_{t−1} to answer B_t = B_{t−1} + 1 mm in every x: its error grows
/// frame by frame, and every restart sets it back.
CompensationModel drifting_network(const ArmDescription& arm) {
  CompensationModel model = zero_network(arm);
  const int size = 3 * arm.point_count();
  const int state = 2 * arm.segment_count();
  Eigen::MatrixXf& weight = model.layers[0].weight;
  weight.middleCols(state, size).setIdentity();
  weight.middleCols(state + size, size) = -Eigen::MatrixXf::Identity(size, size);
  for (int i = 0; i < size; i += 3) {
    model.layers[0].bias[i] = 0.001F;
  }
  return model;
}

/// A still arm: pressures change nothing, motions of 40 frames.
Episode still_episode(const ArmDescription& arm, int frames) {
  Episode episode = toy_episode(arm, 1, frames - 1, 1, 1e6F);
  for (int t = 0; t < frames; ++t) {
    episode.motion_index[static_cast<std::size_t>(t)] = std::max(0, t - 1) / 40;
  }
  return episode;
}

// Finite, but not for long: every frame multiplies what the one before it came to.
TEST(Evaluate, AModelThatRunsOffToInfinityIsRefusedWithEpisodeAndFrame) {
  const ArmDescription arm = three_segment_arm();
  CompensationModel model = drifting_network(arm);
  model.layers[0].weight *= 1e18F;
  model.layers[0].bias.setConstant(1e18F);
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, model);
  EXPECT_THAT([&] { (void)evaluate(no_load, &network, {still_episode(arm, 161)}); },
              ThrowsMessage<InputError>(HasSubstr("prediction of episode 0 is not finite")));
}

TEST(Evaluate, ErrorsOfADriftFollowTheRestarts) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, drifting_network(arm));
  const Evaluation evaluation = evaluate(no_load, &network, {still_episode(arm, 161)});
  ASSERT_TRUE(evaluation.network.has_value());
  const RolloutErrors& errors = *evaluation.network;
  EXPECT_EQ(evaluation.frames, 160);
  EXPECT_NEAR(errors.one_step.position_cm.mean, 0.1, kMicrometre_cm);
  EXPECT_NEAR(errors.window_32.position_cm.mean, 0.1 * 33 / 2, kMicrometre_cm);
  EXPECT_NEAR(errors.per_motion.position_cm.mean, 0.1 * 41 / 2, kMicrometre_cm);
  EXPECT_NEAR(errors.open_loop.position_cm.mean, 0.1 * 161 / 2, kDriftRounding_cm);
  // Uniform over 160 values 0.1 cm apart; 95 % of the way from the first to the last.
  EXPECT_NEAR(errors.open_loop.position_cm.p95, 0.1 * (1.0 + 0.95 * 159), kDriftRounding_cm);
  EXPECT_NEAR(errors.open_loop.position_cm.std, 0.1 * std::sqrt((160.0 * 160.0 - 1) / 12),
              kDriftRounding_cm);
  EXPECT_NEAR(errors.open_loop.orientation_rad.mean, 0.0, 1e-6);
  // The last of four motions of 40 frames: frames 121 to 160.
  EXPECT_NEAR(errors.open_loop.position_cm.worst_motion, 0.1 * 140.5, kDriftRounding_cm);
  EXPECT_NEAR(errors.per_motion.position_cm.worst_motion, 0.1 * 41 / 2, kMicrometre_cm);
  EXPECT_TRUE(std::isnan(errors.one_step_moving.position_cm.mean)) << "the arm stands still";
  EXPECT_NEAR(evaluation.noise_multiplied, 1.0, 0.15) << "of 320 numbers";
}

TEST(Evaluate, MovingFramesAreThoseInWhichTheTipMoves) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, drifting_network(arm));
  Episode episode = still_episode(arm, 50);
  const Eigen::Index tip = episode.backbone.cols() - 3;
  for (int t = 20; t < 50; ++t) {
    episode.backbone(t, tip) += 0.01F * static_cast<float>(std::min(t - 19, 5));
  }
  const Evaluation evaluation = evaluate(no_load, &network, {episode});
  // Five frames, 1 cm each, of which the network says 1 mm.
  EXPECT_NEAR(evaluation.hold_one_step_moving.position_cm.mean, 1.0, kMicrometre_cm);
  EXPECT_NEAR(evaluation.hold_one_step.position_cm.mean, 5.0 / 49, kMicrometre_cm);
  EXPECT_NEAR(evaluation.network->one_step_moving.position_cm.mean, 0.9, kMicrometre_cm);
  EXPECT_NEAR(evaluation.network->one_step.position_cm.mean, (5 * 0.9 + 44 * 0.1) / 49,
              kMicrometre_cm);
}

TEST(TipErrorSeries, MotionsOfAnotherEpisodeAreOtherMotions) {
  TipErrorSeries series;
  append(series, {{1.0, 3.0}, {0.0, 0.0}, {0, 1}, {true, false}, {0.5, 1.5}});
  append(series, {{5.0, 7.0}, {0.0, 0.0}, {0, 0}, {false, true}, {2.5, 3.5}});
  EXPECT_THAT(series.motion, ElementsAre(0, 1, 2, 2));
  EXPECT_EQ(summarise(series).position_cm.worst_motion, 6.0);
  EXPECT_THAT(moving_frames(series).position_cm, ElementsAre(1.0, 7.0));
  EXPECT_THAT(moving_frames(series).plates_cm, ElementsAre(0.5, 3.5));
}

TEST(LongRollout, TellsADriftFromAModelThatStays) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = {toy_episode(arm, 10, 20, 4)};
  const LongRollout steady = roll_out_long(ForwardModel(arm, zero_network(arm)), episodes, 3000);
  EXPECT_TRUE(steady.bounded);
  EXPECT_EQ(steady.frames, 3000);
  EXPECT_LE(steady.max_distance_m, arm.length_m());
  EXPECT_GT(steady.max_distance_m, 0.3 * arm.length_m());
  const ForwardModel drifting(arm, drifting_network(arm));
  EXPECT_TRUE(roll_out_long(drifting, episodes, 100).bounded);
  const LongRollout drift = roll_out_long(drifting, episodes, 3000);
  EXPECT_FALSE(drift.bounded);
  EXPECT_GT(drift.max_distance_m, 2.9);  // 1 mm a frame
}

TEST(LongRollout, CountsTheFramesInWhichBoundsHoldTheModel) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = {toy_episode(arm, 10, 20, 4)};
  CompensationModel steady = zero_network(arm);
  steady.bounds = gap_bounds_of(episodes);
  EXPECT_EQ(roll_out_long(ForwardModel(arm, steady), episodes, 1000).held_share, 0.0);
  CompensationModel drifting = drifting_network(arm);
  drifting.bounds = steady.bounds;
  const LongRollout held = roll_out_long(ForwardModel(arm, drifting), episodes, 3000);
  EXPECT_GT(held.held_share, LongRollout::kMaxHeldShare);
  EXPECT_LE(held.max_distance_m, 2.0 * arm.length_m());
  EXPECT_FALSE(held.bounded) << "near, but because its bounds hold it";
}

// A model may stay on the longest episode and run away on another.
TEST(LongRollout, WalksTheFourLongestEpisodesInTurn) {
  const ArmDescription arm = three_segment_arm();
  const Episode known = toy_episode(arm, 10, 20, 4);
  Episode wild = known;
  wild.pressure_kpa *= 2.0F;  // bends further than what the bounds were made of
  CompensationModel model = zero_network(arm);
  model.bounds = gap_bounds_of({known});
  const ForwardModel forward(arm, model);
  const LongRollout rollout = roll_out_long(forward, {known, known, known, wild}, 3000);
  EXPECT_EQ(rollout.frames, 3000);
  EXPECT_GT(rollout.held_share, LongRollout::kMaxHeldShare);
  EXPECT_LE(rollout.held_share, 0.25);
  EXPECT_EQ(roll_out_long(forward, {known, known, known, known, wild}, 3000).held_share, 0.0)
      << "the fifth is left out";
}

TEST(Evaluate, AZeroNetworkIsTheNoLoadModel) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, zero_network(arm));
  const Evaluation evaluation = evaluate(no_load, &network, {toy_episode(arm, 10, 20, 4)});
  EXPECT_GT(evaluation.no_load_open_loop.position_cm.mean, 1.0);
  EXPECT_NEAR(evaluation.network->open_loop.position_cm.mean,
              evaluation.no_load_open_loop.position_cm.mean, kMicrometre_cm);
  EXPECT_NEAR(evaluation.position_reduction_percent, 0.0, 1e-3);
  EXPECT_EQ(evaluation.noise_multiplied, 0.0) << "it has no memory";
}

TEST(Evaluate, BaselinesOfSteadyMotion) {
  const ArmDescription arm = three_segment_arm();
  Episode episode = still_episode(arm, 50);
  const Eigen::Index tip = episode.backbone.cols() - 3;
  for (int t = 0; t < 50; ++t) {
    episode.backbone(t, tip) = 0.01F * static_cast<float>(t);      // 1 cm a frame
    episode.backbone(t, tip + 2) = 0.02F * static_cast<float>(t);  // 0.02 rad a frame
  }
  const Evaluation evaluation = evaluate(ForwardModel(arm), nullptr, {episode});
  EXPECT_FALSE(evaluation.network.has_value());
  EXPECT_NEAR(evaluation.hold_one_step.position_cm.mean, 1.0, kMicrometre_cm);
  EXPECT_NEAR(evaluation.hold_one_step.orientation_rad.mean, 0.02, 1e-6);
  EXPECT_NEAR(evaluation.constant_velocity_one_step.position_cm.mean, 0.0, kMicrometre_cm);
}

// What is filled in between tracked frames is a guess: nothing is measured there, and nothing
// starts from there.
TEST(Evaluate, UntrackedFramesChangeNothing) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, drifting_network(arm));
  Episode episode = toy_episode(arm, 5, 20, 3);
  episode.tracked.assign(101, 1);
  for (const int t : {0, 32, 33, 41, 61, 100}) {
    episode.tracked[static_cast<std::size_t>(t)] = 0;
  }
  const auto before = to_json(evaluate(no_load, &network, {episode}));
  for (int t = 0; t < 101; ++t) {
    if (!episode.was_tracked(t)) {
      episode.backbone.row(t).setConstant(100.0F);
    }
  }
  EXPECT_EQ(before, to_json(evaluate(no_load, &network, {episode})));
  const std::vector<Episode> episodes = {episode};
  const auto pieces = pieces_of_length(episodes, 32);
  EXPECT_LT(mean_tip_error_m(roll_out(network, episodes, pieces, 1), episodes, pieces), 1.0);
}

/// The same episode, seen in every `period`-th frame alone, or in all but those.
Episode tracked_now_and_then(Episode episode, int period, bool tracked) {
  for (int t = 0; t < episode.frame_count(); ++t) {
    episode.tracked.push_back((t % period == 0) == tracked ? 1 : 0);
  }
  return episode;
}

/// The frames of a series in which the arm was tracked; the series begins with frame 1.
TipErrorSeries seen_frames(const TipErrorSeries& series, const Episode& episode) {
  TipErrorSeries result;
  for (int t = 1; t < episode.frame_count(); ++t) {
    const auto at = static_cast<std::size_t>(t - 1);
    if (episode.was_tracked(t)) {
      result.position_cm.push_back(series.position_cm[at]);
      result.orientation_rad.push_back(series.orientation_rad[at]);
      result.motion.push_back(series.motion[at]);
    }
  }
  return result;
}

TEST(Evaluate, TheNoLoadModelsErrorsAreThoseOfTheSameFramesOfATrackedRecording) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const Episode whole = toy_episode(arm, 5, 20, 3);
  const TipErrorSeries all = tip_errors(predict(no_load, whole, Restart::every_frame), whole);
  for (const int period : {2, 3}) {
    for (const bool tracked : {true, false}) {
      const Episode episode = tracked_now_and_then(whole, period, tracked);
      const TipErrorSeries expected = seen_frames(all, episode);
      const TipErrorSeries found = seen_frames(
          tip_errors(predict(no_load, episode, Restart::every_frame), episode), episode);
      EXPECT_EQ(found.position_cm, expected.position_cm);
      EXPECT_EQ(found.orientation_rad, expected.orientation_rad);
      const Evaluation evaluation = evaluate(no_load, nullptr, {episode});
      EXPECT_EQ(evaluation.frames, std::ssize(expected.position_cm));
      EXPECT_GT(evaluation.no_load_open_loop.position_cm.mean, 1.0);
      EXPECT_EQ(evaluation.no_load_open_loop.position_cm.mean,
                summarise(expected).position_cm.mean);
      EXPECT_EQ(evaluation.no_load_open_loop.position_cm.worst_motion,
                summarise(expected).position_cm.worst_motion);
    }
  }
}

// Given frames as predictions would read as errors of 0, the more the shorter the pieces.
TEST(Evaluate, AFrameGivenAsAStartIsNoPrediction) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, drifting_network(arm));
  const Episode whole = still_episode(arm, 161);
  // Seen in 1, 2, 4, 5, 7, 8, …: of each pair the first is a start, the second one step from it.
  const Evaluation pairs = evaluate(no_load, &network, {tracked_now_and_then(whole, 3, false)});
  EXPECT_EQ(pairs.frames, 107);
  EXPECT_NEAR(pairs.network->one_step.position_cm.mean, 0.1, kMicrometre_cm);
  EXPECT_NEAR(pairs.network->one_step.position_cm.p95, 0.1, kMicrometre_cm);
  // Seen in every second frame: no frame is one step from one that was seen.
  const Evaluation single = evaluate(no_load, &network, {tracked_now_and_then(whole, 2, true)});
  EXPECT_EQ(single.frames, 80);
  EXPECT_TRUE(std::isnan(single.network->one_step.position_cm.mean));
  EXPECT_TRUE(std::isnan(single.network->one_step.position_cm.worst_motion));
  EXPECT_TRUE(std::isnan(single.hold_one_step.position_cm.mean));
  EXPECT_NEAR(single.network->window_32.position_cm.mean, 0.1 * 17, kMicrometre_cm);
  EXPECT_NEAR(single.network->open_loop.position_cm.mean, 0.1 * 81, kDriftRounding_cm);
  const auto json = to_json(single);
  EXPECT_TRUE(json.at("/network/one_step/position_error_cm/mean"_json_pointer).is_null());
  EXPECT_THAT(to_text(single), HasSubstr("network, one step                     -"));
}

TEST(Evaluate, StopsOnCtrlC) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = {toy_episode(arm, 5, 20, 3)};
  EXPECT_EXIT(exit_interrupted([&] { evaluate(ForwardModel(arm), nullptr, episodes); }),
              testing::ExitedWithCode(0), "stopped on request");
  EXPECT_EXIT(
      exit_interrupted([&] { roll_out_long(ForwardModel(arm, zero_network(arm)), episodes); }),
      testing::ExitedWithCode(0), "stopped on request");
}

TEST(Pieces, BeginWhereTheArmWasSeen) {
  Episode episode;
  episode.time_s.setLinSpaced(10, 0.0, 0.45);
  episode.motion_index = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2};
  episode.tracked = {0, 1, 1, 0, 0, 1, 1, 1, 1, 1};
  const auto in_numbers = [](const std::vector<RolloutPiece>& pieces) {
    std::vector<std::array<int, 2>> numbers;
    for (const RolloutPiece& piece : pieces) {
      numbers.push_back({piece.first, piece.frames});
    }
    return numbers;
  };
  EXPECT_THAT(in_numbers(pieces_of_length({episode}, 3)),
              ElementsAre(std::array{1, 3}, std::array{5, 3}, std::array{8, 1}));
  EXPECT_THAT(in_numbers(pieces_of_motions({episode})),
              ElementsAre(std::array{1, 2}, std::array{5, 1}, std::array{6, 3}));
}

TEST(Evaluate, DoesNotDependOnTheNumberOfJobs) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, drifting_network(arm));
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    episodes.push_back(toy_episode(arm, 4 + static_cast<int>(seed), 20, seed));
  }
  EXPECT_EQ(to_json(evaluate(no_load, &network, episodes, 1)),
            to_json(evaluate(no_load, &network, episodes, 4)));
}

TEST(Evaluate, RefusesRecordingsTooShort) {
  const ArmDescription arm = three_segment_arm();
  EXPECT_THAT([&] { evaluate(ForwardModel(arm), nullptr, {still_episode(arm, 2)}); },
              ThrowsMessage<InputError>(
                  HasSubstr("2 frames in 1 episodes; expected an episode of at least 3 frames")));
}

TEST(EvaluationJson, HasTheContractsKeys) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  const ForwardModel network(arm, zero_network(arm));
  const nlohmann::ordered_json json =
      to_json(evaluate(no_load, &network, {toy_episode(arm, 2, 20, 4)}));
  for (const char* path :
       {"/no_load/open_loop", "/network/one_step", "/network/one_step_moving", "/network/window_32",
        "/network/per_motion", "/network/open_loop", "/baselines/hold/one_step",
        "/baselines/hold/one_step_moving", "/baselines/constant_velocity/one_step",
        "/baselines/constant_velocity/one_step_moving"}) {
    for (const char* quantity : {"position_error_cm", "orientation_error_rad"}) {
      for (const char* statistic : {"mean", "std", "p95", "worst_motion"}) {
        const nlohmann::ordered_json::json_pointer pointer(std::string(path) + "/" + quantity +
                                                           "/" + statistic);
        EXPECT_TRUE(json.contains(pointer)) << pointer;
      }
    }
  }
  EXPECT_EQ(json.at("frames"), 40);
  EXPECT_TRUE(json.at("reduction_percent").contains("position"));
  EXPECT_TRUE(json.at("reduction_percent").contains("orientation"));
}

TEST(Pieces, OfMotionsStartFromTheFrameBeforeEach) {
  Episode episode;
  episode.time_s.setLinSpaced(7, 0.0, 0.3);
  episode.motion_index = {0, 0, 0, 1, 1, 2, 2};
  std::vector<std::array<int, 3>> pieces;
  for (const RolloutPiece& piece : pieces_of_motions({episode})) {
    pieces.push_back({piece.episode, piece.first, piece.frames});
  }
  EXPECT_THAT(pieces, ElementsAre(std::array{0, 0, 2}, std::array{0, 2, 2}, std::array{0, 4, 2}));
}

TEST(RollOut, BatchesAgreeWithOneQueryAfterTheOther) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel network(arm, drifting_network(arm));
  const Episode episode = toy_episode(arm, 8, 20, 4);
  const FrameMatrix predicted = predict(network, episode, Restart::every_32_frames);
  ForwardModel::Workspace workspace;
  Backbone state(arm.point_count(), 3);
  for (int t = 1; t < episode.frame_count(); ++t) {
    if ((t - 1) % 32 == 0) {
      state.reshaped<Eigen::RowMajor>() = episode.backbone.row(t - 1).transpose();
    }
    const Pressures before = episode.pressure_kpa.row(t - 1);
    const Pressures now = episode.pressure_kpa.row(t);
    network.step(before, now, state, state, workspace);
    EXPECT_TRUE(predicted.row(t).transpose() == state.reshaped<Eigen::RowMajor>()) << "frame " << t;
  }
}

}  // namespace
}  // namespace limber
