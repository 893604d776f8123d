#include "limber/training/yardsticks.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/random_stream.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/report/evaluation_plots.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kMicrometre_cm = 1e-4;
constexpr double kFitted_cm = 0.04;  // ridge and single precision

const RolloutErrors& errors_of(const std::string& key, const YardstickReport& report) {
  return std::ranges::find(report.predictors, key, &PredictorErrors::key)->errors.value();
}

YardstickReport measured(const std::vector<Episode>& episodes) {
  const ArmDescription arm = three_segment_arm();
  return measure_yardsticks(arm, ForwardModel(arm), nullptr, episodes, {});
}

/// An arm whose poses are a linear function of its commands.
Episode linear_episode(int frames, std::uint64_t seed) {
  const ArmDescription arm = three_segment_arm();
  Episode episode = toy_episode(arm, frames / 20, 20, seed);
  RandomStream random(7, 0);
  Eigen::MatrixXf map(episode.backbone.cols(), episode.pressure_kpa.cols());
  for (float& value : map.reshaped()) {
    value = static_cast<float>(random.uniform(-1e-3, 1e-3));
  }
  episode.backbone = episode.pressure_kpa * map.transpose();
  return episode;
}

TEST(Yardsticks, ALinearArmIsPredictedByALine) {
  const YardstickReport report =
      measured({linear_episode(200, 1), linear_episode(200, 2), linear_episode(200, 3)});
  EXPECT_LT(errors_of("linear_one_step", report).open_loop.position_cm.mean, kFitted_cm);
  EXPECT_LT(errors_of("linear_one_step", report).open_loop.plates_cm.mean, kFitted_cm);
  EXPECT_GT(errors_of("hold", report).open_loop.position_cm.mean, 1.0);
}

TEST(Yardsticks, ASimpleArmIsPredictedByTheSimpleModel) {
  const ArmDescription arm = three_segment_arm();
  const SimpleModel truth{{{0.8, 0.1, 1.0}, {1.1, 0.0, 1.02}, {0.9, -0.1, 1.0}}, 0.2};
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    episodes.push_back(toy_episode(arm, 10, 30, seed));
    episodes.back().backbone = predict(truth, arm, episodes.back());
  }
  const YardstickReport report = measured(episodes);
  const RolloutErrors& errors = errors_of("simple_model", report);
  EXPECT_LT(errors.open_loop.position_cm.mean, 0.5);
  EXPECT_NEAR(errors.open_loop.position_cm.mean, errors.window_32.position_cm.mean, 0.1);
}

TEST(Yardsticks, HoldErrsByNothingWhereNothingMoves) {
  const ArmDescription arm = three_segment_arm();
  Episode still = toy_episode(arm, 10, 30, 1);
  for (int t = 1; t < still.frame_count(); ++t) {
    still.backbone.row(t) = still.backbone.row(0);
  }
  const YardstickReport report = measured({still});
  for (const char* key : {"hold", "constant_velocity"}) {
    const RolloutErrors& errors = errors_of(key, report);
    EXPECT_NEAR(errors.one_step.position_cm.mean, 0.0, kMicrometre_cm);
    EXPECT_NEAR(errors.window_32.position_cm.mean, 0.0, kMicrometre_cm);
    EXPECT_TRUE(std::isnan(errors.one_step_moving.position_cm.mean));
  }
}

// Restarting more often helps whatever has a memory, and changes nothing for what has none.
TEST(Yardsticks, CurvesReachFromOneFrameToTheWholeEpisode) {
  const ArmDescription arm = three_segment_arm();
  const YardstickReport report =
      measured({toy_episode(arm, 10, 30, 1), toy_episode(arm, 5, 30, 2)});
  EXPECT_EQ(report.horizon_frames.front(), 1);
  EXPECT_EQ(report.horizon_frames.back(), 300);
  for (const PredictorErrors& curve : report.predictors) {
    ASSERT_EQ(curve.tip_cm.size(), report.horizon_frames.size());
    ASSERT_EQ(curve.episode_cm.size(), 2U);
    if (curve.key == "hold") {
      EXPECT_LT(curve.tip_cm.front(), curve.tip_cm.back());
      EXPECT_NEAR(curve.tip_cm.front(), errors_of("hold", report).one_step.position_cm.mean,
                  kMicrometre_cm);
    }
    if (curve.key == "no_load" || curve.key == "simple_model") {
      EXPECT_NEAR(curve.tip_cm.front(), curve.tip_cm.back(), kMicrometre_cm);
    }
  }
}

TEST(Yardsticks, TooFewFramesAreNotFittedTo) {
  const YardstickReport report = measured({toy_episode(three_segment_arm(), 2, 30, 1)});
  EXPECT_EQ(report.predictors.size(), 3U);  // the no-load model, and what is not fitted
  EXPECT_THAT(report.fitted_to, ::testing::HasSubstr("nothing"));
}

TEST(Folds, NoFrameIsPredictedByAFitToIt) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> one = {toy_episode(arm, 10, 10, 1)};
  const Folds pieces(one, false);
  for (int fold = 0; fold < pieces.count(); ++fold) {
    std::vector<double> times;
    for (const Episode& part : pieces.training(one, fold)) {
      times.insert(times.end(), part.time_s.begin(), part.time_s.end());
    }
    for (int t = 0; t < one[0].frame_count(); ++t) {
      const bool trained = std::find(times.begin(), times.end(), one[0].time_s[t]) != times.end();
      EXPECT_EQ(trained, pieces.of(0, t) != fold);
    }
  }
  std::vector<Episode> seven;
  for (std::uint64_t seed = 0; seed < 7; ++seed) {
    seven.push_back(toy_episode(arm, 1, 10 + int(seed), seed));
  }
  const Folds episodes(seven, false);
  for (int fold = 0; fold < episodes.count(); ++fold) {
    for (const Episode& trained : episodes.training(seven, fold)) {
      EXPECT_NE(episodes.of(trained.frame_count() - 11, 0), fold);
    }
  }
}

TEST(YardstickReport, HasEveryHorizonInJson) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = {toy_episode(arm, 10, 30, 1), toy_episode(arm, 10, 30, 2)};
  const YardstickReport report = measured(episodes);
  const nlohmann::ordered_json json = to_json(report, episodes);
  for (const char* name : {"hold", "constant_velocity", "linear_one_step", "simple_model"}) {
    for (const char* horizon :
         {"one_step", "one_step_moving", "window_32", "per_motion", "open_loop"}) {
      EXPECT_TRUE(json["baselines"][name][horizon].contains("plates_error_cm")) << name << horizon;
    }
  }
  EXPECT_EQ(json["episodes"].size(), 2U);
  EXPECT_GT(json["episodes"][1]["tip_error_cm"]["no_load"].get<double>(), 0.0);
  EXPECT_THAT(to_text(report), ::testing::HasSubstr("fitted simple model"));
}

TEST(Yardsticks, HorizonsAloneAreTheSameAndTellHowFarTheyAre) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = {linear_episode(400, 1)};
  std::vector<double> all_shares;
  const YardstickReport all =
      measure_yardsticks(arm, ForwardModel(arm), nullptr, episodes, {}, 1,
                         [&](double share) { all_shares.push_back(share); });
  EXPECT_TRUE(std::ranges::is_sorted(all_shares));
  EXPECT_EQ(all_shares.size(), all.predictors.size() * all.horizon_frames.size());
  EXPECT_EQ(all_shares.back(), 1.0);
  std::vector<double> shares;
  const YardstickReport some = measure_horizons(ForwardModel(arm), nullptr, episodes, 1,
                                                [&](double share) { shares.push_back(share); });
  EXPECT_EQ(some.horizon_frames, all.horizon_frames);
  ASSERT_EQ(some.predictors.size(), 2U);
  for (const PredictorErrors& curve : some.predictors) {
    const auto same = std::ranges::find(all.predictors, curve.key, &PredictorErrors::key);
    EXPECT_EQ(curve.tip_cm, same->tip_cm) << curve.key;
  }
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.size(), 2 * some.horizon_frames.size());
  EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace limber
