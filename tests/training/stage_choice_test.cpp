#include "limber/training/stage_choice.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TrainingData toy_data(const ArmDescription& arm) {
  TrainingData data;
  data.training = {toy_episode(arm, 4, 20, 1), toy_episode(arm, 4, 20, 2)};
  data.validation = {toy_episode(arm, 3, 20, 50)};
  return data;
}

TrainingSettings small_settings() {
  TrainingSettings settings = best_preset();
  settings.hidden_units = {8};
  settings.stages = {{2, 64, 20}, {8, 32, 20}, {32, 16, 20}};
  return settings;
}

TEST(ChooseStages, SpendsNoMoreEpochsThanThePresetHas) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  const StageChoice choice = choose_stages(arm, toy_data(arm), settings);
  ASSERT_EQ(choice.tried.size(), 3U);
  EXPECT_THAT(choice.tried[0].window_frames, ElementsAre(32));
  EXPECT_THAT(choice.tried[1].window_frames, ElementsAre(8, 32));
  EXPECT_THAT(choice.tried[2].window_frames, ElementsAre(2, 8, 32));
  EXPECT_EQ(choice.race_epochs, 10);
  EXPECT_EQ(choice.epochs + 3 * choice.race_epochs, 60);
  EXPECT_EQ(settings.epoch_count(), choice.epochs);
  EXPECT_EQ(windows_of(settings),
            choice.tried[static_cast<std::size_t>(choice.chosen)].window_frames);
  // The best one, or windows of 32 if they are nearly as good.
  for (const WindowsTried& tried : choice.tried) {
    EXPECT_GE(
        tried.score_cm(),
        (1.0 - kClearlyBetter) * choice.tried[static_cast<std::size_t>(choice.chosen)].score_cm());
  }
}

TEST(ShareEpochs, TakesNoMoreTimeThanOneNetwork) {
  TrainingSettings settings = small_settings();
  const int epochs = settings.epoch_count();
  share_epochs(settings, 3);
  EXPECT_EQ(settings.ensemble, 3);
  EXPECT_LE(3 * settings.epoch_count(), epochs);
  EXPECT_GT(3 * (settings.epoch_count() + 1), epochs);
  share_epochs(settings, 1000);
  EXPECT_EQ(settings.epoch_count(), 3);  // one for each stage
}

TEST(NetworkCount, IsThreeForWhatWasMeasured) {
  const ArmDescription arm = three_segment_arm();
  const auto count_for = [&](double hours) {
    TrainingData data;
    data.training.resize(2);
    for (Episode& episode : data.training) {
      episode.time_s.setZero(static_cast<Eigen::Index>(hours * 3600.0 * arm.frame_rate_hz / 2.0));
    }
    return network_count_for(arm, data);
  };
  EXPECT_EQ(count_for(0.5), 1);
  EXPECT_EQ(count_for(2.0), 3);
  EXPECT_EQ(count_for(10.0), 1);
}

TEST(ChooseStages, DoesNotDependOnThreads) {
  const ArmDescription arm = three_segment_arm();
  std::string texts[2];
  for (const int jobs : {1, 3}) {
    TrainingSettings settings = small_settings();
    settings.jobs = jobs;
    texts[jobs == 1 ? 0 : 1] = to_json(choose_stages(arm, toy_data(arm), settings)).dump();
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(ChooseStages, EndsWhereItsCallerSaysSo) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  int epochs = 0;
  TrainingHooks hooks;
  hooks.on_epoch = [&](const LearningCurvePoint&) { ++epochs; };
  hooks.should_stop = [&] { return epochs >= 3; };
  EXPECT_THROW(choose_stages(arm, toy_data(arm), settings, hooks), Interrupted);
  EXPECT_EQ(epochs, 3);
}

TEST(ChooseStages, RefusesDataThatChooseNothing) {
  const ArmDescription arm = three_segment_arm();
  TrainingSettings settings = small_settings();
  TrainingData data = toy_data(arm);
  data.validation.clear();
  EXPECT_THAT([&] { choose_stages(arm, data, settings); },
              ThrowsMessage<InputError>(HasSubstr("hold_back_validation")));
}

TEST(StageChoice, ComesBackFromItsFile) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "choice.json";
  StageChoice choice{{{{2, 8, 32}, 0.5, 1.25, 5.0},
                      {{32},
                       std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::infinity()}},
                     0,
                     12,
                     400};
  write_choice(path, choice);
  EXPECT_EQ(to_json(read_choice(path)), to_json(choice));
  EXPECT_EQ(read_choice(path).tried[0].window_32_cm, 1.25);
  EXPECT_THAT(to_text(choice), HasSubstr("2 8 32: 2.5 cm, chosen; 32: inf cm"));
  TrainingSettings settings = best_preset();
  apply(read_choice(path), settings);
  EXPECT_THAT(windows_of(settings), ElementsAre(2, 8, 32));
  EXPECT_EQ(settings.epoch_count(), 400);
  write_file_atomically(path,
                        "{\"windows\": [8], \"epochs\": 9, \"race_epochs\": 1, \"tried\": []}");
  EXPECT_THAT([&] { (void)read_choice(path); },
              ThrowsMessage<InputError>(HasSubstr("these windows were not tried")));
}

}  // namespace
}  // namespace limber
