#include "limber/training/training_settings.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(TrainingPreset, PaperIsThePapers) {
  const TrainingSettings paper = training_preset("paper");
  EXPECT_EQ(paper.layout, BackboneLayout::base_poses);
  EXPECT_EQ(paper.scaling, Scaling::unit_range);
  EXPECT_EQ(paper.optimiser, Optimiser::sgd);
  EXPECT_EQ(paper.learning_rate, 1e-4);
  EXPECT_EQ(paper.hidden_units, (std::vector<int>{100, 100, 100}));
  ASSERT_EQ(paper.stages.size(), 1U);
  EXPECT_EQ(paper.stages[0].window_frames, 32);
  EXPECT_EQ(paper.stages[0].windows_per_batch, 128);
  EXPECT_EQ(paper.epoch_count(), 6000);
  EXPECT_NO_THROW(require_usable(paper));
  EXPECT_NO_THROW(require_usable(training_preset("best")));
}

TEST(TrainingPreset, NamesThePresetsThereAre) {
  EXPECT_THAT([] { (void)training_preset("better"); },
              ThrowsMessage<InputError>(HasSubstr("--preset better: expected paper or best")));
}

TEST(SetEpochCount, KeepsProportionsAndTheSum) {
  TrainingSettings settings;
  settings.stages = {{2, 8, 200}, {8, 8, 100}, {32, 8, 200}};
  set_epoch_count(settings, 50);
  EXPECT_EQ(settings.stages[0].epochs, 20);
  EXPECT_EQ(settings.stages[1].epochs, 10);
  EXPECT_EQ(settings.stages[2].epochs, 20);
  for (int epochs = 3; epochs < 40; ++epochs) {
    set_epoch_count(settings, epochs);
    EXPECT_EQ(settings.epoch_count(), epochs);
    for (const TrainingStage& stage : settings.stages) {
      EXPECT_GE(stage.epochs, 1);
    }
  }
  EXPECT_THAT([&] { set_epoch_count(settings, 2); },
              ThrowsMessage<InputError>(HasSubstr("2 epochs; preset 'best' has 3 stages")));
}

TEST(SetWindowFrames, KeepsTheEpochsAndSharesThem) {
  TrainingSettings settings = best_preset();
  const int epochs = settings.epoch_count();
  set_window_frames(settings, {32, 5});
  ASSERT_EQ(settings.stages.size(), 2U);
  EXPECT_EQ(settings.stages[0].window_frames, 32);
  EXPECT_EQ(settings.stages[0].windows_per_batch, 32);
  EXPECT_EQ(settings.stages[1].windows_per_batch, 204);
  EXPECT_EQ(settings.epoch_count(), epochs);
  EXPECT_EQ(settings.stages[0].epochs, epochs / 2);
  settings.stages = {{32, 64, 1}};
  EXPECT_THAT(
      [&] {
        set_window_frames(settings, {2, 8});
      },
      ThrowsMessage<InputError>(HasSubstr("1 epochs; preset 'best' has 2 stages")));
}

TEST(RequireUsable, NamesTheSettingAndWhatIsAllowed) {
  const auto refusal = [](auto change, const char* message) {
    TrainingSettings settings = best_preset();
    change(settings);
    EXPECT_THAT([&] { require_usable(settings); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refusal([](auto& s) { s.scaling = Scaling::shared_range; },
          "shared_range with output_form gated_change and layout gap_poses");
  refusal([](auto& s) { s.scaling = Scaling::range_by_unit; },
          "range_by_unit with output_form gated_change and layout gap_poses");
  refusal([](auto& s) { s.weight_decay = -1.0; }, "weight_decay = -1; expected >= 0");
  refusal([](auto& s) { s.weight_decay = 400.0; }, "expected below 1 / weight_decay (400)");
  refusal([](auto& s) { s.learning_rate = 0.0; },
          "learning_rate = 0; expected a finite number > 0");
  refusal([](auto& s) { s.learning_rate = std::nan(""); }, "learning_rate = nan");
  refusal([](auto& s) { s.stages[0].window_frames = 0; }, "stages.window_frames = 0");
  refusal([](auto& s) { s.hidden_units = {100, 0}; }, "hidden_units = 0");
  refusal([](auto& s) { s.stages.clear(); }, "stages");
}

}  // namespace
}  // namespace limber
