#include "limber/training/window_stages.hpp"

#include <gtest/gtest.h>

#include "training/toy_arm.hpp"

namespace limber {
namespace {

TEST(ShareEpochs, TakesNoMoreTimeThanOneNetwork) {
  TrainingSettings settings = best_preset();
  settings.stages = {{2, 64, 20}, {8, 32, 20}, {32, 16, 20}};
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

}  // namespace
}  // namespace limber
