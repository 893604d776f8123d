#include "limber/training/fine_tuning.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/report/training_report.hpp"
#include "limber/training/trainer.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<Episode> toy_episodes(const ArmDescription& arm, std::uint64_t first_seed, int count,
                                  float play_kpa) {
  std::vector<Episode> episodes;
  for (int k = 0; k < count; ++k) {
    episodes.push_back(
        toy_episode(arm, 20, 20, first_seed + static_cast<std::uint64_t>(k), play_kpa));
  }
  return episodes;
}

TEST(FineTuning, KeepsTheLastStageAlone) {
  const TrainingSettings preset = best_preset();
  const TrainingSettings tuning = fine_tuning_of(preset);
  ASSERT_EQ(tuning.stages.size(), 1U);
  EXPECT_EQ(tuning.stages[0].window_frames, preset.stages.back().window_frames);
  EXPECT_LT(tuning.stages[0].epochs, preset.stages.back().epochs);
  EXPECT_LT(tuning.learning_rate, preset.learning_rate);
  EXPECT_EQ(preset.optimiser, Optimiser::soap);
  EXPECT_EQ(tuning.optimiser, Optimiser::adam);
  EXPECT_EQ(tuning.first_frames_power, 0.0);
}

/// An arm whose play has grown, and what tuning on it does to the model, without and with replay.
class FineTuningOfAnAgedArm : public testing::Test {
 protected:
  FineTuningOfAnAgedArm() {
    settings_.hidden_units = {32, 32};
    settings_.stages = {{2, 32, 60}, {8, 16, 30}};
    young_ = train(arm_, {toy_episodes(arm_, 0, 6, 10.0F), old_validation_, {}}, settings_).model;
    settings_ = fine_tuning_of(settings_);
    settings_.stages[0].epochs = 20;
    settings_.learning_rate = 1e-3;  // few epochs here
  }

  FineTuningReport tuned(double replay_share) {
    settings_.replay_share = replay_share;
    TrainingData data{toy_episodes(arm_, 20, 3, 40.0F), new_validation_, {}};
    if (replay_share > 0.0) {
      data.replay = toy_episodes(arm_, 0, 6, 10.0F);
    }
    const CompensationModel after = fine_tune(arm_, data, settings_, young_).model;
    return compare_models(arm_, young_, after, new_validation_, old_validation_, 2);
  }

  const ArmDescription arm_ = three_segment_arm();
  const std::vector<Episode> old_validation_ = toy_episodes(arm_, 40, 2, 10.0F);
  const std::vector<Episode> new_validation_ = toy_episodes(arm_, 50, 2, 40.0F);
  TrainingSettings settings_ = best_preset();
  CompensationModel young_;
};

TEST_F(FineTuningOfAnAgedArm, LearnsTheNewAndForgetsTheOldUnlessItIsReplayed) {
  const FineTuningReport plain = tuned(0.0);
  const FineTuningReport replayed = tuned(0.5);
  const auto error = [](const RolloutErrors& errors) { return errors.window_32.position_cm.mean; };
  EXPECT_LT(error(plain.new_data->after), error(plain.new_data->before));
  EXPECT_LT(error(replayed.new_data->after), error(replayed.new_data->before));
  EXPECT_LT(error(replayed.old_data->after), error(plain.old_data->after));
}

TEST(FineTuningReport, ShowsWhatWasMeasured) {
  FineTuningReport report;
  report.new_data.emplace();
  report.new_data->after.open_loop.position_cm.mean = 1.25;
  EXPECT_THAT(to_text(report), AllOf(HasSubstr("new data, after"), HasSubstr("     1.25\n"),
                                     Not(HasSubstr("old data"))));
  const nlohmann::ordered_json json = to_json(report);
  EXPECT_TRUE(json.at("old_data").is_null());
  EXPECT_EQ(json["new_data"]["after"]["open_loop"]["position_error_cm"]["mean"], 1.25);
}

}  // namespace
}  // namespace limber
