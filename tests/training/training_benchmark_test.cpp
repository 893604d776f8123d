#include "limber/training/training_benchmark.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/safetensors.hpp"
#include "support/exit_interrupted.hpp"
#include "support/temporary_folder.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

class TrainingBenchmark : public testing::Test {
 protected:
  TrainingBenchmark() { settings_.jobs = 2; }
  const ArmDescription arm_ = three_segment_arm();
  const TrainingData data_{{toy_episode(arm_, 10, 20, 1)}, {}, {}};
  TrainingSettings settings_ = paper_preset();
};

TEST_F(TrainingBenchmark, CountsUsefulMultiplyAddsOnly) {
  const TrainingSpeed speed = measure_training_speed(arm_, data_, settings_, 1);
  EXPECT_EQ(speed.shape, "102-100-100-100-48");
  EXPECT_EQ(speed.frames, 201);
  ASSERT_EQ(speed.stages.size(), 1U);
  const StageSpeed& stage = speed.stages[0];
  EXPECT_EQ(stage.windows, 6);
  // Forward and gradients 2·35000, deltas 24800 and 48·100 in 31 of 32 frames; 6·32 queries.
  EXPECT_DOUBLE_EQ(stage.multiply_adds, 192 * (2 * 35000.0 + 24800.0 + 4800.0 * 31 / 32));
  EXPECT_GT(stage.epoch_s, 0.0);
  EXPECT_GT(stage.fraction_of_fma_peak, 0.0);
  EXPECT_LT(stage.fraction_of_fma_peak, 1.0);
  settings_.ensemble = 3;
  EXPECT_DOUBLE_EQ(measure_training_speed(arm_, data_, settings_, 1).stages[0].multiply_adds,
                   3.0 * stage.multiply_adds);
}

// What a peer gets must be what the first epoch starts from.
TEST_F(TrainingBenchmark, WritesTablesForAPeer) {
  const TemporaryFolder folder;
  settings_ = best_preset();
  write_training_tables(folder.path() / "t.safetensors", arm_, data_, settings_);
  const Safetensors content =
      parse_safetensors(read_file(folder.path() / "t.safetensors"), "t.safetensors");
  EXPECT_EQ(content.metadata.at("optimiser"), "soap");
  EXPECT_EQ(content.tensors.at("pressure").shape, (std::vector<std::size_t>{201, 3}));
  EXPECT_EQ(content.tensors.at("starts.0").shape, (std::vector<std::size_t>{6}));
  const std::vector<std::size_t>& shape = content.tensors.at("layers.0.weight").shape;
  EXPECT_EQ(shape, (std::vector<std::size_t>{200, 105}));
}

TEST_F(TrainingBenchmark, StopsOnCtrlC) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(exit_interrupted([&] { measure_training_speed(arm_, data_, settings_, 1); }),
              testing::ExitedWithCode(0), "stopped on request");
}

}  // namespace
}  // namespace limber
