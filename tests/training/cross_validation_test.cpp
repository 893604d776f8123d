#include "limber/training/cross_validation.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

struct Little {
  ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes;
  TrainingSettings settings = preset_for_little();

  explicit Little(int count = 5) {
    settings.hidden_units = {4};
    settings.jobs = 1;
    for (int seed = 1; seed <= count; ++seed) {
      episodes.push_back(toy_episode(arm, 2, 34, static_cast<std::uint64_t>(seed)));
    }
  }

  CrossValidation found() const { return cross_validate(arm, episodes, settings, {}); }
};

/// Found once, for all tests that look at it.
const CrossValidation& found_once() {
  static const CrossValidation found = Little().found();
  return found;
}

/// An arm that was told nothing, and does nothing.
Episode at_rest(const ArmDescription& arm) {
  Episode episode = toy_episode(arm, 2, 34, 9);
  episode.pressure_kpa.setZero();
  episode.setpoint_kpa.setZero();
  episode.backbone.rowwise() = Eigen::RowVectorXf(episode.backbone.row(0));
  return episode;
}

TEST(CrossValidation, TakesTheWayThatPredictsUnseenEpisodesBest) {
  const CrossValidation& found = found_once();
  EXPECT_EQ(found.folds, kFolds);
  ASSERT_EQ(found.tried.size(), 2U);
  EXPECT_EQ(found.best().folds, kFolds);
  for (const WayTried& tried : found.tried) {
    EXPECT_TRUE(tried.folds == 1 || tried.score_cm() >= found.best().score_cm());
    EXPECT_LT(tried.one_step_cm, tried.window_600_cm);
  }
  ASSERT_TRUE(found.prediction_error);
  EXPECT_GE(found.prediction_error->runs, 10) << "every episode's motions count";
}

TEST(CrossValidation, IsTheSameForAnyNumberOfThreads) {
  Little little;
  little.settings.jobs = 2;
  EXPECT_EQ(little.found(), found_once());
}

TEST(CrossValidation, WhatRestsJudgesNoNetwork) {
  Little little;
  const CrossValidation& found = found_once();
  for (int i = 0; i < 3; ++i) {
    little.episodes.push_back(at_rest(little.arm));
  }
  const CrossValidation with_rest = little.found();
  ASSERT_TRUE(with_rest.prediction_error);
  EXPECT_EQ(with_rest.prediction_error->runs, found.prediction_error->runs);
  for (std::size_t i = 0; i < found.tried.size();
       ++i) {  // three of eight that judged would lower it by a third
    EXPECT_GT(with_rest.tried[i].window_600_cm, 0.7 * found.tried[i].window_600_cm);
  }
  EXPECT_FALSE(is_little(little.arm, {at_rest(little.arm), at_rest(little.arm)}));
}

// As a tracker records that is slower than the arm: no step ahead has an end that was seen.
TEST(CrossValidation, WhatNothingWasMeasuredForDecidesNothing) {
  Little little;
  for (Episode& episode : little.episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      episode.tracked.push_back(t % 2 == 0 ? 1 : 0);
    }
  }
  const CrossValidation found = little.found();
  EXPECT_EQ(found.best().folds, kFolds);
  EXPECT_EQ(found.best().one_step_cm, 0.0);
  EXPECT_GT(found.best().window_32_cm, 0.0);
  EXPECT_NEAR(found.best().score_cm(),
              std::sqrt(found.best().window_32_cm * found.best().window_600_cm), 1e-9);
  EXPECT_THAT(to_text(found), HasSubstr(": not measured, "));
  EXPECT_EQ(read_cross_validation(to_json(found).dump(), "f.json"), found);
}

TEST(CrossValidation, OneLongEpisodeIsCutIntoFolds) {
  Little little(0);
  little.episodes = {toy_episode(little.arm, 12, 34, 1)};
  EXPECT_TRUE(is_little(little.arm, little.episodes));
  EXPECT_EQ(little.found().folds, kFolds);
}

TEST(CrossValidation, OneNetworkThenLearnsFromEverythingForThatLong) {
  const Little little;
  const CrossValidation& found = found_once();
  const TrainingResult result =
      train_on_everything(little.arm, little.episodes, little.settings, {}, found);
  EXPECT_EQ(result.status, TrainingStatus::finished);
  EXPECT_EQ(result.best_epoch, found.epochs());
  EXPECT_EQ(result.model.training.at("training_frames"), std::to_string(5 * 69));
  EXPECT_EQ(result.model.prediction_error, found.prediction_error);
  EXPECT_TRUE(result.model.learnt);
}

TEST(CrossValidation, AfterTheChosenWayDivergedTheBestOfTheOthersIsTakenWithoutAnError) {
  CrossValidation found = found_once();
  const Optimiser first = found.best().optimiser;
  EXPECT_TRUE(take_another_way(found));
  EXPECT_NE(found.best().optimiser, first);
  EXPECT_FALSE(found.prediction_error);
  EXPECT_THAT(to_text(found), HasSubstr("diverged"));
  EXPECT_EQ(read_cross_validation(to_json(found).dump(), "f.json"), found);
  EXPECT_FALSE(take_another_way(found)) << "both did";
}

TEST(CrossValidation, AWayThatWasLeftAfterOneFoldIsTakenLast) {
  CrossValidation found;
  found.folds = kFolds;
  found.tried = {{300, {200}, Optimiser::soap, kFolds, 0.1, 1.0, 1.5},
                 {300, {200}, Optimiser::adam, 1, 0.1, 1.0, 1.6},
                 {300, {100}, Optimiser::adam, kFolds, 0.2, 2.0, 3.0}};
  EXPECT_TRUE(take_another_way(found));
  EXPECT_EQ(found.chosen, 2);
  EXPECT_TRUE(take_another_way(found));
  EXPECT_EQ(found.chosen, 1);
  EXPECT_FALSE(take_another_way(found));
}

TEST(CrossValidation, ItsFileSaysTheSame) {
  CrossValidation found = found_once();
  found.tried.back().window_600_cm = std::numeric_limits<double>::infinity();
  found.tube =
      Tube{{1e-4, 0.02}, 0.03, 0.1, {0.4, 0.1}, "motions", {{0.95, 1.1, 90, 4, 0.5, 0, 0}}};
  const std::string text = to_json(found).dump();
  EXPECT_EQ(read_cross_validation(text, "f.json"), found);
  EXPECT_THAT([] { (void)read_cross_validation("{\"folds\": 9}", "f.json"); },
              ThrowsMessage<InputError>(HasSubstr("f.json")));
}

TEST(CrossValidation, ItsIdentityIsOfEverythingThatItsErrorsAreMadeOf) {
  Little little;
  const auto identity = [&] {
    return folds_identity(little.arm, little.episodes, little.settings);
  };
  const std::string own = identity();
  little.episodes[1].setpoint_kpa(3, 0) += 1.0F;
  EXPECT_NE(identity(), own);
  little.episodes[1].setpoint_kpa(3, 0) -= 1.0F;
  EXPECT_EQ(identity(), own);
  little.episodes[2].tracked.assign(69, 1);
  little.episodes[2].tracked[5] = 0;
  EXPECT_NE(identity(), own);
}

TEST(CrossValidation, StopsWhereItIsAsked) {
  const Little little;
  TrainingHooks hooks;
  hooks.should_stop = [] { return true; };
  EXPECT_THROW((void)cross_validate(little.arm, little.episodes, little.settings, {}, hooks),
               Interrupted);
}

TEST(KeepEpoch, IsTheEpochOfTheNetworkWhateverTheLossSays) {
  const Little little;
  TrainingData data;
  data.training = little.episodes;
  TrainingSettings settings = little.settings;
  set_epoch_count(settings, 30);
  settings.keep_epoch = 7;
  const TrainingResult result = train(little.arm, data, settings);
  const std::vector<int>& ran_away = result.passed_over_epochs;  // so small, it may
  EXPECT_EQ(ran_away.empty() ? result.best_epoch : ran_away.front(), 7);
  EXPECT_EQ(result.curve.size(), 7U);
  data.validation = {little.episodes.front()};
  EXPECT_THAT([&] { (void)train(little.arm, data, settings); },
              ThrowsMessage<InputError>(HasSubstr("so would validation")));
  data.validation.clear();
  settings.keep_epoch = 31;
  EXPECT_THAT([&] { (void)train(little.arm, data, settings); },
              ThrowsMessage<InputError>(HasSubstr("keep_epoch")));
}

}  // namespace
}  // namespace limber
