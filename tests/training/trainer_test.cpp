#include "limber/training/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/training/evaluation.hpp"
#include "src/training/rollout.hpp"
#include "support/temporary_folder.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

TrainingData toy_data(const ArmDescription& arm) {
  TrainingData data;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    data.training.push_back(toy_episode(arm, 20, 20, seed));
  }
  data.validation = {toy_episode(arm, 10, 20, 50)};
  return data;
}

TrainingSettings small_settings() {
  TrainingSettings settings = best_preset();
  settings.hidden_units = {32, 32};
  settings.stages = {{2, 64, 30}, {8, 32, 10}};
  settings.optimiser = Optimiser::adam;  // SOAP begins slowly
  settings.weight_decay = 0.0;
  settings.jobs = 2;
  return settings;
}

bool same_layers(const std::vector<Layer>& a, const std::vector<Layer>& b) {
  return std::ranges::equal(a, b, [](const Layer& x, const Layer& y) {
    return x.weight == y.weight && x.bias == y.bias;
  });
}

bool same_weights(const CompensationModel& a, const CompensationModel& b) {
  return same_layers(a.layers, b.layers) &&
         std::ranges::equal(a.more_members, b.more_members, same_layers);
}

// The toy's memory is in its backbone alone, so a pure function of (q, B) can learn it.
TEST(Train, LearnsAnArmWithPlay) {
  constexpr int kSeeds = 3;  // of so small a network on so little data, one alone may be lucky
  const ArmDescription arm = three_segment_arm();
  const ForwardModel no_load(arm);
  TrainingSettings settings = small_settings();
  settings.reads_velocity = false;
  settings.stages = {{2, 32, 200}, {8, 16, 100}};
  double reduction_percent = 0.0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    settings.seed = static_cast<std::uint64_t>(seed);
    const TrainingResult result = train(arm, toy_data(arm), settings);
    ASSERT_EQ(result.status, TrainingStatus::finished);
    ASSERT_EQ(result.curve.size(), 300U);
    EXPECT_LT(result.curve.back().loss, 0.5 * result.curve.front().loss);
    const ForwardModel network(arm, result.model);
    const Evaluation evaluation = evaluate(no_load, &network, {toy_episode(arm, 20, 20, 99)});
    reduction_percent += evaluation.position_reduction_percent / kSeeds;
  }
  EXPECT_GT(reduction_percent, 25.0);  // 34 measured, 0 untrained
}

/// A step of one batch.
TrainingSettings one_step() {
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 100'000, 1}};
  return settings;
}

TEST(Train, WeightDecayShortensWhatAStepLeaves) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = one_step();
  const CompensationModel without = train(arm, toy_data(arm), settings).model;
  settings.weight_decay = 50.0;
  const CompensationModel with = train(arm, toy_data(arm), settings).model;
  const float share = 1.0F - static_cast<float>(settings.learning_rate * settings.weight_decay);
  for (std::size_t layer = 0; layer < without.layers.size(); ++layer) {
    EXPECT_TRUE(with.layers[layer].weight.isApprox(share * without.layers[layer].weight, 1e-6F));
  }
}

TEST(Train, LeavesOutBoundsThatAreNotAskedFor) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = one_step();
  EXPECT_TRUE(train(arm, toy_data(arm), settings).model.bounds);
  settings.bounded = false;
  EXPECT_FALSE(train(arm, toy_data(arm), settings).model.bounds);
}

// A step of Adam moves a weight by the learning rate at most.
TEST(Train, BeginsWithPyTorchsWeightsWhereAsked) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = one_step();
  settings.first_weights = FirstWeights::torch;
  const CompensationModel model = train(arm, toy_data(arm), settings).model;
  for (const Layer& layer : model.layers) {
    const float limit = 1.0F / std::sqrt(static_cast<float>(layer.weight.cols()));
    const float step = 1.01F * static_cast<float>(settings.learning_rate);
    EXPECT_LT(layer.weight.cwiseAbs().maxCoeff(), limit + step);
    EXPECT_GT(layer.weight.cwiseAbs().maxCoeff(), 0.9F * limit);
  }
  // The biases too: with He's weights a step would leave them at 0.003.
  EXPECT_GT(model.layers[1].bias.cwiseAbs().maxCoeff(), 0.5F / std::sqrt(32.0F));
}

TEST(Train, GivesTheSameBitsForAnyNumberOfJobs) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 2}, {8, 32, 2}};
  settings.jobs = 1;
  const TrainingResult one = train(arm, toy_data(arm), settings);
  settings.jobs = 3;
  const TrainingResult three = train(arm, toy_data(arm), settings);
  EXPECT_TRUE(same_weights(one.model, three.model));
  EXPECT_EQ(one.best_validation_position_error_cm, three.best_validation_position_error_cm);
  settings.seed = 2;
  EXPECT_FALSE(same_weights(one.model, train(arm, toy_data(arm), settings).model));
}

TEST(Train, PassesOverEpochsThatRunAwayAndKeepsTheNextBest) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 8}};
  const TrainingResult result = train(arm, toy_data(arm), settings);
  ASSERT_TRUE(result.model.bounds.has_value());
  EXPECT_EQ(result.long_rollout.frames, kLongRolloutFrames);
  const auto error_of = [&](int epoch) {
    return result.curve[static_cast<std::size_t>(epoch) - 1].validation_position_error_cm;
  };
  EXPECT_EQ(error_of(result.best_epoch), result.best_validation_position_error_cm);
  for (const int epoch : result.passed_over_epochs) {
    EXPECT_LE(error_of(epoch), error_of(result.best_epoch));
  }
  if (!result.passed_over_epochs.empty()) {
    EXPECT_TRUE(result.long_rollout.bounded);
  }
  // The same rollout, made here.
  const LongRollout again =
      roll_out_long(ForwardModel(arm, result.model), toy_data(arm).validation);
  EXPECT_EQ(again.held_share, result.long_rollout.held_share);
  EXPECT_EQ(again.bounded, result.long_rollout.bounded);
}

// Sharing batches must change nothing: each member is what it would have become alone. The first
// one's weights are drawn as a single network's are.
TEST(Train, AMemberOfAnEnsembleIsTheNetworkItWouldBeAlone) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 2}, {8, 32, 2}};
  settings.validation_interval = 4;  // the last epoch alone: both keep that one
  const TrainingResult single = train(arm, toy_data(arm), settings);
  settings.ensemble = 3;
  settings.jobs = 1;
  const TrainingResult three = train(arm, toy_data(arm), settings);
  ASSERT_EQ(three.model.member_count(), 3);
  int found = 0;
  for (int k = 0; k < 3; ++k) {
    found += same_layers(three.model.member(k).layers, single.model.layers) ? 1 : 0;
  }
  EXPECT_EQ(found, 1);
  EXPECT_FALSE(same_layers(three.model.member(1).layers, three.model.member(2).layers));
  // The best first.
  ASSERT_EQ(three.member_validation_position_error_cm.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(three.member_validation_position_error_cm));
  const ForwardModel best(arm, three.model.member(0));
  const std::vector<Episode> validation = toy_data(arm).validation;
  const auto pieces = pieces_of_length(validation, 600);
  EXPECT_DOUBLE_EQ(
      100.0 * mean_tip_error_m(roll_out(best, validation, pieces, 1), validation, pieces),
      three.member_validation_position_error_cm[0]);
}

// Learnt once by this code: other numbers are another recipe, whose figures the docs don't have.
TEST(Train, PaperPresetFollowsItsStoredCurve) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = paper_preset();
  set_epoch_count(settings, 30);
  const TrainingResult result = train(arm, toy_data(arm), settings);
  ASSERT_EQ(result.status, TrainingStatus::finished);
  EXPECT_EQ(result.model.shape(), "102-100-100-100-48");
  // Processors round differently, and SGD carries that on: 0.3 % after 5 epochs, 6 % after 30.
  const struct {
    int epoch;
    double loss;
    double share;
  } stored[] = {{1, 22.00043, 1e-3}, {2, 18.15087, 2e-3},  {5, 14.11592, 0.01},
                {10, 12.71916, 0.1}, {20, 11.07247, 0.15}, {30, 10.67148, 0.15}};
  for (const auto& [epoch, loss, share] : stored) {
    const LearningCurvePoint& point = result.curve.at(static_cast<std::size_t>(epoch - 1));
    EXPECT_NEAR(point.loss, loss, share * loss) << "epoch " << epoch;
  }
}

TEST(Train, KeepsTheBestByValidation) {
  const ArmDescription arm = three_segment_arm();
  const TrainingResult result = train(arm, toy_data(arm), small_settings());
  double least = std::numeric_limits<double>::infinity();
  for (const LearningCurvePoint& point : result.curve) {
    least = std::fmin(least, point.validation_position_error_cm);  // NaN: not validated
  }
  EXPECT_EQ(result.best_validation_position_error_cm, least);
  const auto best = static_cast<std::size_t>(result.best_epoch - 1);
  EXPECT_EQ(result.curve.at(best).validation_position_error_cm, least);
}

TEST(Train, StopsWhereItDivergesAndSaysWhatToTry) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = paper_preset();
  settings.learning_rate = 10.0;
  set_epoch_count(settings, 50);
  const TrainingResult result = train(arm, toy_data(arm), settings);
  EXPECT_EQ(result.status, TrainingStatus::diverged);
  EXPECT_THAT(result.message, StartsWith("training diverged in epoch "));
  EXPECT_THAT(result.message, HasSubstr("at learning rate 10: loss "));
  EXPECT_THAT(result.message, HasSubstr("Try --learning-rate 1"));
}

TEST(Train, RefusesEpisodesShorterThanAWindow) {
  const ArmDescription arm = three_segment_arm();
  const TrainingData data{{toy_episode(arm, 1, 20, 1), toy_episode(arm, 1, 29, 2)}, {}};
  EXPECT_THAT(
      [&] { (void)train(arm, data, best_preset()); },
      ThrowsMessage<InputError>(HasSubstr(
          "the longest training episode has 30 frames; preset 'best' needs windows of 32")));
}

// A shift beyond the few tracked frames leaves no window: such an epoch is not shifted.
TEST(Train, EveryEpochHasAWindow) {
  const ArmDescription arm = three_segment_arm();
  TrainingData data;
  data.training = {toy_episode(arm, 2, 20, 1)};
  data.training[0].tracked.assign(41, 0);
  std::fill_n(data.training[0].tracked.begin(), 3, std::uint8_t{1});
  TrainingSettings settings = small_settings();
  settings.stages = {{32, 4, 6}};
  const TrainingResult result = train(arm, data, settings);
  ASSERT_EQ(result.curve.size(), 6U);
  for (const LearningCurvePoint& point : result.curve) {
    EXPECT_TRUE(std::isfinite(point.loss)) << "epoch " << point.epoch;
  }
}

class TrainWith : public testing::TestWithParam<std::tuple<int, Optimiser>> {};

INSTANTIATE_TEST_SUITE_P(NetworksAndOptimisers, TrainWith,
                         testing::Combine(testing::Values(1, 3),
                                          testing::Values(Optimiser::adam, Optimiser::soap)));

TEST_P(TrainWith, ResumesWithTheBitsOfAnUnbrokenRun) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings = small_settings();
  settings.ensemble = std::get<0>(GetParam());
  settings.optimiser = std::get<1>(GetParam());
  settings.stages = {{2, 64, 3}, {8, 32, 3}};
  const TrainingResult unbroken = train(arm, toy_data(arm), settings);

  settings.checkpoint = folder.path() / "model.safetensors.checkpoint";
  settings.checkpoint_interval_s = 0.0;
  settings.stop_after_epochs = 4;
  const TrainingResult first = train(arm, toy_data(arm), settings);
  ASSERT_EQ(first.status, TrainingStatus::interrupted);
  ASSERT_EQ(first.curve.size(), 4U);
  ASSERT_TRUE(std::filesystem::exists(settings.checkpoint));
  settings.stop_after_epochs = 0;
  settings.resume = true;
  const TrainingResult second = train(arm, toy_data(arm), settings);
  ASSERT_EQ(second.status, TrainingStatus::finished);
  EXPECT_TRUE(same_weights(second.model, unbroken.model));
  EXPECT_EQ(second.best_epoch, unbroken.best_epoch);
  ASSERT_EQ(second.curve.size(), 6U);
  EXPECT_EQ(second.curve[5].loss, unbroken.curve[5].loss);
  // Only a finished run's caller knows when the model is safe on disk: until then it can be asked
  // for again.
  ASSERT_TRUE(std::filesystem::exists(settings.checkpoint));
  EXPECT_TRUE(same_weights(train(arm, toy_data(arm), settings).model, unbroken.model));
}

TEST(Train, TellsItsCallerOfEveryEpoch) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 2}, {8, 32, 3}};
  std::vector<double> losses;
  TrainingHooks hooks;
  hooks.on_epoch = [&](const LearningCurvePoint& point) { losses.push_back(point.loss); };
  const TrainingResult result = train(arm, toy_data(arm), settings, hooks);
  ASSERT_EQ(losses.size(), 5U);
  for (std::size_t i = 0; i < losses.size(); ++i) {
    EXPECT_EQ(losses[i], result.curve[i].loss);
  }
}

// The epoch that was begun is dropped: the checkpoint is that of the epoch before.
TEST(Train, StopsInTheMiddleOfAnEpochAndGoesOnToTheSameBits) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 6}};
  const TrainingResult unbroken = train(arm, toy_data(arm), settings);
  settings.checkpoint = folder.path() / "checkpoint";
  settings.checkpoint_interval_s = 0.0;
  int epochs = 0;
  int batches = 0;
  TrainingHooks hooks;
  hooks.on_epoch = [&](const LearningCurvePoint&) { ++epochs; };
  hooks.should_stop = [&] { return epochs == 3 && ++batches > 2; };
  const TrainingResult stopped = train(arm, toy_data(arm), settings, hooks);
  EXPECT_EQ(stopped.status, TrainingStatus::interrupted);
  EXPECT_EQ(stopped.curve.size(), 3U);
  settings.resume = true;
  EXPECT_TRUE(same_weights(train(arm, toy_data(arm), settings).model, unbroken.model));
}

TEST(Train, RefusesTheCheckpointOfAnotherRun) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings = small_settings();
  settings.checkpoint = folder.path() / "run.checkpoint";
  settings.stop_after_epochs = 1;
  (void)train(arm, toy_data(arm), settings);
  settings.resume = true;
  settings.learning_rate *= 2.0;
  EXPECT_THAT([&] { (void)train(arm, toy_data(arm), settings); },
              ThrowsMessage<InputError>(HasSubstr(
                  "run.checkpoint: the checkpoint of a run with other data or settings")));
  settings.learning_rate /= 2.0;
  set_epoch_count(settings, 20);
  EXPECT_THAT(
      [&] { (void)train(arm, toy_data(arm), settings); },
      ThrowsMessage<InputError>(
          AllOf(HasSubstr("the checkpoint of a run of 30 epochs of 2-frame windows, 64 per batch, "
                          "10 epochs of 8-frame windows"),
                HasSubstr("this one is to be 15 epochs"), HasSubstr("leave out --resume"))));
  write_file_atomically(settings.checkpoint, read_file(settings.checkpoint).substr(0, 500));
  EXPECT_THAT([&] { (void)train(arm, toy_data(arm), settings); },
              ThrowsMessage<InputError>(HasSubstr("run.checkpoint")));
}

TEST(Train, TimeLimitFixesTheEpochs) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  settings.stages = {{2, 64, 300}, {8, 32, 100}};
  settings.time_limit_s = 1.5;  // most of it goes to the measurement itself
  const TrainingResult result = train(arm, toy_data(arm), settings);
  EXPECT_EQ(result.status, TrainingStatus::finished);
  EXPECT_EQ(std::to_string(result.curve.size()), result.model.training.at("epochs"));
}

TEST(FineTune, GoesOnFromTheWeightsGiven) {
  const ArmDescription arm = three_segment_arm();
  const TrainingData data = toy_data(arm);
  const TrainingResult first = train(arm, data, small_settings());
  TrainingSettings settings = small_settings();
  settings.stages = {{8, 32, 1}};
  settings.learning_rate = 1e-9;
  settings.hidden_units = {7};  // the model's own count
  const TrainingResult second = fine_tune(arm, data, settings, first.model);
  EXPECT_EQ(second.model.shape(), first.model.shape());
  EXPECT_NEAR(second.best_validation_position_error_cm, first.best_validation_position_error_cm,
              1e-2);
}

TEST(FineTune, RefusesAnotherArmsModel) {
  const ArmDescription arm = three_segment_arm();
  CompensationModel other;
  other.arm_name = "octopus";
  other.arm_hash = "0123";
  EXPECT_THAT([&] { (void)fine_tune(arm, toy_data(arm), small_settings(), other); },
              ThrowsMessage<InputError>(HasSubstr("trained for arm 'octopus' (hash 0123)")));
}

TEST(LearningCurve, LeavesCellsEmptyWhereNothingWasMeasured) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "curve.csv";
  write_learning_curve_csv(path, {{1, 2, 1e-3, 12.5, std::nan(""), 0.25}, {2, 8, 5e-4, 6, 3.5, 1}});
  EXPECT_EQ(read_file(path),
            "epoch,window_frames,learning_rate,loss,validation_position_error_cm,elapsed_s\n"
            "1,2,0.001,12.5,,0.250\n"
            "2,8,0.0005,6,3.5,1.000\n");
}

}  // namespace
}  // namespace limber
