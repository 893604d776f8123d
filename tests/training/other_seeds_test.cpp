#include "src/training/other_seeds.hpp"

#include <vector>

#include <gmock/gmock.h>

namespace limber {
namespace {

/// Trainings whose networks run away, or not, in this order.
struct Trainings {
  std::vector<bool> bounded;
  std::vector<TrainingSettings> settings;

  TrainingResult operator()(const TrainingSettings& with) {
    TrainingResult result;
    result.long_rollout = {.frames = 20'000, .bounded = bounded[settings.size()]};
    result.best_epoch = int(settings.size()) + 1;
    result.wall_time_s = 1.0;
    settings.push_back(with);
    return result;
  }
  TrainingResult of_seed_7() {
    TrainingSettings with;
    with.seed = 7;
    with.checkpoint = "run.checkpoint";
    return train_until_bounded([this](const TrainingSettings& one) { return (*this)(one); }, with);
  }
};

TEST(OtherSeeds, AreNotTriedWhereTheNetworkDoesNotRunAway) {
  Trainings trainings{{true}, {}};
  const TrainingResult result = trainings.of_seed_7();
  EXPECT_EQ(trainings.settings.size(), 1);
  EXPECT_EQ(result.model.training.count("passed_over_seeds"), 0);
}

TEST(OtherSeeds, AreTriedUntilANetworkDoesNotRunAway) {
  Trainings trainings{{false, false, true}, {}};
  const TrainingResult result = trainings.of_seed_7();
  ASSERT_EQ(trainings.settings.size(), 3);
  EXPECT_EQ(result.best_epoch, 3);
  EXPECT_EQ(result.wall_time_s, 2.0) << "its own, and the first one's";
  EXPECT_EQ(result.model.training.at("passed_over_seeds"),
            "7 " + std::to_string(trainings.settings[1].seed));
  EXPECT_NE(trainings.settings[1].seed, trainings.settings[2].seed);
  EXPECT_EQ(trainings.settings[0].checkpoint, "run.checkpoint");
  EXPECT_TRUE(trainings.settings[1].checkpoint.empty());
}

TEST(OtherSeeds, LeaveTheFirstNetworkWhereAllRunAway) {
  Trainings trainings{std::vector<bool>(8, false), {}};
  const TrainingResult result = trainings.of_seed_7();
  EXPECT_EQ(trainings.settings.size(), 1 + kMostOtherSeeds);
  EXPECT_EQ(result.best_epoch, 1);
  EXPECT_FALSE(result.long_rollout.bounded);
}

}  // namespace
}  // namespace limber
