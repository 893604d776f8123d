#include "src/training/checkpoint.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/safetensors.hpp"
#include "support/temporary_folder.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Json = nlohmann::json;

TrainingData toy_data(const ArmDescription& arm) {
  TrainingData data;
  data.training = {toy_episode(arm, 4, 20, 1), toy_episode(arm, 4, 20, 2)};
  data.validation = {toy_episode(arm, 3, 20, 50)};
  return data;
}

/// The one epoch that a state says was validated.
Json rival(int epoch, double error_m, const Json& members_m) {
  Json one = {{"epoch", epoch}, {"error_m", error_m}, {"members_m", members_m}};
  return Json::array({std::move(one)});
}

/// A run of two networks, stopped within its second stage, and its checkpoint to be damaged.
class DamagedCheckpoint : public ::testing::Test {
 protected:
  void SetUp() override {
    settings_.hidden_units = {8};
    settings_.ensemble = 2;
    settings_.optimiser = Optimiser::soap;
    settings_.stages = {{2, 64, 2}, {8, 32, 4}};
    settings_.checkpoint = folder_.path() / "run.checkpoint";
    settings_.stop_after_epochs = 3;
    ASSERT_EQ(train(arm_, toy_data(arm_), settings_).status, TrainingStatus::interrupted);
    whole_ = read_file(settings_.checkpoint);
    settings_.stop_after_epochs = 0;
    settings_.resume = true;
  }

  /// What resuming says of a checkpoint that was changed.
  std::string refusal(const std::function<void(Safetensors&, Json&)>& damage) {
    Safetensors content = parse_safetensors(whole_, "c");
    Json state = Json::parse(content.metadata.at("state"));
    damage(content, state);
    content.metadata["state"] = state.dump();
    return refusal_of(safetensors_bytes(content));
  }

  std::string refusal_of(const std::string& bytes) {
    write_file_atomically(settings_.checkpoint, bytes);
    try {
      (void)train(arm_, toy_data(arm_), settings_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
  ArmDescription arm_ = three_segment_arm();
  TrainingSettings settings_ = best_preset();
  std::string whole_;
};

TEST_F(DamagedCheckpoint, UnharmedItIsResumed) {
  EXPECT_EQ(refusal([](Safetensors&, Json&) {}), "accepted");
}

TEST_F(DamagedCheckpoint, NumbersOfItsStateAreRefusedByName) {
  struct Case {
    const char* field;
    Json value;
  };
  const Case cases[] = {
      {"epochs_done", 1'000'000'000},
      {"epochs_done", -2'147'483'648},
      {"epochs_done", 2'147'483'648},
      {"epochs_done", 3.5},
      {"epochs_done", 6},  // as many as the run has: finished, though nothing was trained
      {"epochs_done", 2},
      {"epochs_done", nullptr},
      {"step", -1},
      {"step", 1e300},
      {"stage_first_loss", Json::array()},
      {"stage_first_loss", {1.0}},
      {"stage_first_loss", {1.0, -1.0}},
      {"rivals", rival(4, 0.1, {0.1, 0.1})},
      {"rivals", rival(0, 0.1, {0.1, 0.1})},
      {"rivals", rival(2, -1.0, {0.1, 0.1})},
      {"rivals", rival(2, 0.1, Json::array())},
      {"rivals", rival(2, 0.1, {0.1, "x"})},
      {"curve", Json::array()},
      {"curve", {1, 2, 3}},
      {"curve", {{}, {}, {}}},
      {"curve", {{1, 2, 0.1, 1.0, nullptr, 1.0}, {1, 2, 0.1, 1.0, nullptr, 1.0}, {3, 8}}},
      {"elapsed_s", -1.0},
      {"elapsed_s", "soon"},
  };
  for (const Case& broken : cases) {
    const std::string message =
        refusal([&](Safetensors&, Json& state) { state[broken.field] = broken.value; });
    EXPECT_THAT(message, AllOf(StartsWith(settings_.checkpoint.string()),
                               HasSubstr("the checkpoint is damaged"),
                               HasSubstr("remove it and train again")))
        << broken.field << " = " << broken.value;
    EXPECT_THAT(message, AnyOf(HasSubstr(broken.field), HasSubstr("curve")))
        << broken.field << " = " << broken.value;
  }
}

TEST_F(DamagedCheckpoint, StagesAreRefusedWithATimeLimitToo) {
  const Json cases[] = {{{2, 0, 30}},
                        {{2, 64, 2}, {8, -32, 4}},
                        {{2, 64, 2}, {8, 32, 2'000'000'000}},
                        {{2, 64}},
                        Json::array(),
                        "none"};
  for (const bool limited : {false, true}) {
    settings_.time_limit_s = limited ? 2.0 : 0.0;
    for (const Json& stages : cases) {
      EXPECT_THAT(refusal([&](Safetensors&, Json& state) { state["stages"] = stages; }),
                  StartsWith(settings_.checkpoint.string()))
          << stages;
    }
  }
  // Other windows than this run's, which no time limit can have made.
  EXPECT_THAT(refusal([](Safetensors&, Json& state) {
                state["stages"] = {{2, 64, 2}, {16, 32, 4}};
              }),
              HasSubstr("4 epochs of 16-frame windows"));
}

TEST_F(DamagedCheckpoint, TensorsAreRefusedByName) {
  for (const char* name :
       {"parameters", "first_moment", "second_moment", "rotations", "rivals.0"}) {
    const auto expect = [&](const char* why, const std::function<void(Tensor&)>& damage) {
      EXPECT_THAT(
          refusal([&](Safetensors& content, Json&) { damage(content.tensors[name]); }),
          AllOf(StartsWith(settings_.checkpoint.string()), HasSubstr(name), HasSubstr("damaged")))
          << name << " " << why;
    };
    expect("short", [](Tensor& tensor) { tensor = {{2}, {0.5F, 0.5F}}; });
    expect("empty", [](Tensor& tensor) { tensor = {{0}, {}}; });
    expect("not a number",
           [](Tensor& tensor) { tensor.values[1] = std::numeric_limits<float>::quiet_NaN(); });
    expect("infinite",
           [](Tensor& tensor) { tensor.values[0] = std::numeric_limits<float>::infinity(); });
    EXPECT_THAT(refusal([&](Safetensors& content, Json&) { content.tensors.erase(name); }),
                HasSubstr(fmt::format("no tensor {}", name)));
  }
  EXPECT_THAT(refusal([](Safetensors& content, Json&) {
                content.tensors["second_moment"].values[3] = -1.0F;
              }),
              HasSubstr("tensor second_moment: -1 found at 3"));
}

TEST_F(DamagedCheckpoint, NestedOrMissingTextsAreRefused) {
  Safetensors content = parse_safetensors(whole_, "c");
  content.metadata["state"] = "{\"curve\":" + std::string(200'000, '[');
  EXPECT_THAT(refusal_of(safetensors_bytes(content)), HasSubstr("run.checkpoint: state: "));
  content.metadata.erase("state");
  EXPECT_THAT(refusal_of(safetensors_bytes(content)), HasSubstr("no metadata state"));
}

// Where no epoch's error on the validation data is a number, none is the best: nothing is finished.
TEST(Train, WithoutAFiniteValidationErrorItFailsAndLeavesNothingToResume) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings = best_preset();
  settings.hidden_units = {8};
  settings.stages = {{2, 100'000, 1}};  // one batch: the step behind it, which no loss has seen,
  settings.optimiser = Optimiser::adam;
  settings.weight_decay = 0.0;
  settings.learning_rate = 1e25;  // leaves weights whose products overflow
  settings.bounded = false;
  settings.checkpoint = folder.path() / "run.checkpoint";
  settings.checkpoint_interval_s = 1e6;
  const TrainingResult result = train(arm, toy_data(arm), settings);
  EXPECT_EQ(result.status, TrainingStatus::diverged);
  EXPECT_EQ(result.best_epoch, 0);
  EXPECT_THAT(result.message, HasSubstr("validation error"));
  EXPECT_FALSE(std::filesystem::exists(settings.checkpoint));
}

/// Of a run that is to end soon.
TrainingSettings short_run(const TemporaryFolder& folder) {
  TrainingSettings settings = best_preset();
  settings.hidden_units = {8};
  settings.stages = {{2, 64, 6}};
  settings.checkpoint = folder.path() / "run.checkpoint";
  return settings;
}

TEST(Train, RefusesTheCheckpointOfOtherValidationData) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings = short_run(folder);
  settings.stop_after_epochs = 1;
  (void)train(arm, toy_data(arm), settings);
  settings.resume = true;
  settings.stop_after_epochs = 2;
  const auto expect_refused = [&](const TrainingData& data) {
    EXPECT_THAT([&] { (void)train(arm, data, settings); },
                ::testing::ThrowsMessage<InputError>(HasSubstr("a run with other data")));
  };
  TrainingData data = toy_data(arm);
  data.validation[0].pressure_kpa(7, 0) += 1.0F;
  expect_refused(data);
  data = toy_data(arm);
  data.validation[0].tracked.assign(61, 1);
  data.validation[0].tracked[9] = 0;
  expect_refused(data);
  EXPECT_EQ(train(arm, toy_data(arm), settings).curve.size(), 2U);
}

// Within a stage: the first loss of that stage is still known.
TEST(Train, AFinishedRunOfAKeptEpochCanBeAskedForAgain) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingData data = toy_data(arm);
  data.validation.clear();
  TrainingSettings settings = short_run(folder);
  settings.keep_epoch = 3;
  const TrainingResult first = train(arm, data, settings);
  ASSERT_EQ(first.status, TrainingStatus::finished);
  settings.resume = true;
  const TrainingResult again = train(arm, data, settings);
  EXPECT_EQ(again.status, TrainingStatus::finished);
  EXPECT_EQ(again.curve.size(), 3U);
  EXPECT_EQ(again.model.layers[0].weight, first.model.layers[0].weight);
}

TEST(Train, RefusesValidationDataThatMeasureNothing) {
  const ArmDescription arm = three_segment_arm();
  TrainingData data = toy_data(arm);
  for (Episode& episode : data.validation) {
    episode.tracked.assign(static_cast<std::size_t>(episode.frame_count()), 0);
    episode.tracked[30] = 1;  // given to a rollout, not predicted
  }
  TrainingSettings settings = best_preset();
  settings.hidden_units = {8};
  settings.stages = {{2, 64, 1}};
  EXPECT_THAT([&] { (void)train(arm, data, settings); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("no error can be measured")));
  settings.family_size = 1;
  EXPECT_THAT([&] { (void)train(arm, data, settings); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("to be fitted and judged")));
}

// Whoever ends a run between two epochs has not waited long enough for a checkpoint to be due.
TEST(Checkpoint, IsLeftByARunThatIsStoppedBetweenTwoEpochs) {
  const ArmDescription arm = three_segment_arm();
  const TemporaryFolder folder;
  TrainingSettings settings;
  settings.hidden_units = {8};
  settings.stages = {{2, 64, 4}};
  settings.checkpoint = folder.path() / "run.checkpoint";
  settings.checkpoint_interval_s = 1e6;
  int epochs = 0;
  TrainingHooks hooks;
  hooks.on_epoch = [&](const LearningCurvePoint&) { ++epochs; };
  hooks.should_stop = [&] { return epochs == 2; };
  EXPECT_EQ(train(arm, toy_data(arm), settings, hooks).status, TrainingStatus::interrupted);
  ASSERT_TRUE(fs::exists(settings.checkpoint));
  settings.resume = true;
  EXPECT_EQ(train(arm, toy_data(arm), settings).curve.size(), 4U);
}

}  // namespace
}  // namespace limber
