#include "limber/training/trainer.hpp"

#include <algorithm>
#include <cstdint>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(HoldBackValidation, HoldsBackWholeEpisodes) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    episodes.push_back(toy_episode(arm, 2 + static_cast<int>(seed), 20, seed));
  }
  const TrainingData data = hold_back_validation(episodes, 0.2, 3);
  EXPECT_EQ(data.training.size() + data.validation.size(), 10U);
  int held = 0;
  for (const Episode& episode : data.validation) {
    held += episode.frame_count();
  }
  EXPECT_GT(held, 0);
  EXPECT_LE(held, 0.2 * 1310);
}

TEST(HoldBackValidation, SaysWhichEpisodesItHeldBack) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    episodes.push_back(toy_episode(arm, 3, 20, seed));
  }
  const TrainingData data = hold_back_validation(episodes, 0.3, 3);
  ASSERT_EQ(data.held_back.size(), data.validation.size());
  for (std::size_t i = 0; i < data.held_back.size(); ++i) {
    const auto number = static_cast<std::size_t>(data.held_back[i]);
    EXPECT_TRUE(data.validation[i].backbone == episodes[number].backbone);
  }
}

TEST(HoldBackValidation, CutsASingleEpisode) {
  const ArmDescription arm = three_segment_arm();
  const TrainingData data = hold_back_validation({toy_episode(arm, 5, 20, 1)}, 0.2, 1);
  ASSERT_EQ(data.training.size(), 1U);
  ASSERT_EQ(data.validation.size(), 1U);
  EXPECT_EQ(data.training[0].frame_count(), 81);
  EXPECT_EQ(data.validation[0].frame_count(), 20);
  EXPECT_EQ(data.validation[0].backbone.rows(), 20);
  EXPECT_THAT(
      [&] { hold_back_validation({toy_episode(arm, 1, 2, 1)}, 0.1, 1); },
      ThrowsMessage<InputError>(HasSubstr("3 frames are too few to hold some of them back")));
}

TEST(HoldBackValidation, TakesTheEndOfATakeThatIsMostOfWhatThereIs) {
  const ArmDescription arm = three_segment_arm();
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const TrainingData data =
        hold_back_validation({toy_episode(arm, 2, 20, 1), toy_episode(arm, 40, 20, 2)}, 0.1, seed);
    ASSERT_EQ(data.training.size(), 2U);
    ASSERT_EQ(data.validation.size(), 1U);
    EXPECT_EQ(data.held_back, std::vector<int>{1});
    EXPECT_EQ(data.validation[0].frame_count(), 84);
    EXPECT_EQ(data.training[0].frame_count() + data.training[1].frame_count(), 842 - 84);
  }
}

TEST(HoldBackValidation, PassesOverEpisodesThatWereNeverTracked) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    episodes.push_back(toy_episode(arm, 3, 20, seed));
    episodes.back().tracked.assign(61, static_cast<std::uint8_t>(seed % 2));
  }
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    TrainingData data = hold_back_validation(episodes, 0.2, seed);
    ASSERT_EQ(data.held_back.size(), 1U);
    EXPECT_EQ(data.held_back[0] % 2, 1);
    hold_back_unseen(data, 0.2, seed);
    ASSERT_EQ(data.unseen.size(), 1U);
    EXPECT_EQ(data.unseen[0].untracked_count(), 0);
  }
  for (Episode& episode : episodes) {
    episode.tracked.assign(61, 0);
    episode.tracked[30] = 1;
  }
  EXPECT_THAT([&] { hold_back_validation(episodes, 0.2, 1); },
              ThrowsMessage<InputError>(HasSubstr("no frame of 10 episodes was tracked behind")));
}

TEST(HoldBackValidation, TakesAnEndThatWasTracked) {
  Episode whole = toy_episode(three_segment_arm(), 20, 20, 1);  // 401 frames
  whole.tracked.assign(300, 1);
  whole.tracked.resize(401, 0);
  whole.tracked.back() = 1;  // for a single frame again
  TrainingData data = hold_back_validation({whole}, 0.1, 1);
  hold_back_unseen(data, 0.1, 1);
  ASSERT_EQ(data.validation.size(), 1U);
  ASSERT_EQ(data.unseen.size(), 1U);
  EXPECT_TRUE(data.validation[0].backbone == whole.backbone.middleRows(260, 40));
  EXPECT_TRUE(data.unseen[0].backbone == whole.backbone.middleRows(230, 30));
  EXPECT_EQ(data.training[0].frame_count(), 230);
  std::fill(whole.tracked.begin() + 20, whole.tracked.end(), std::uint8_t{0});
  data = hold_back_validation({whole}, 0.1, 1);
  EXPECT_EQ(data.training[0].untracked_count(), 0);
  EXPECT_EQ(data.validation[0].untracked_count(), 0);
}

TEST(HoldBackUnseen, LeavesTheChoiceOfValidationAsItIs) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    episodes.push_back(toy_episode(arm, 2 + static_cast<int>(seed) % 3, 20, seed));
  }
  const TrainingData before = hold_back_validation(episodes, 0.1, 3);
  TrainingData data = before;
  hold_back_unseen(data, 0.1, 3);
  ASSERT_EQ(data.validation.size(), before.validation.size());
  for (std::size_t i = 0; i < data.validation.size(); ++i) {
    EXPECT_TRUE(data.validation[i].backbone == before.validation[i].backbone);
  }
  EXPECT_GT(data.unseen.size(), 0U);
  EXPECT_EQ(data.training.size() + data.unseen.size(), before.training.size());
}

TEST(HoldBackUnseen, OfASingleEpisodeTheLastPartButOne) {
  const Episode whole = toy_episode(three_segment_arm(), 20, 20, 1);  // 401 frames
  TrainingData data = hold_back_validation({whole}, 0.1, 1);
  hold_back_unseen(data, 0.1, 1);
  ASSERT_EQ(data.unseen.size(), 1U);
  EXPECT_EQ(data.training[0].frame_count(), 321);
  EXPECT_EQ(data.unseen[0].frame_count(), 40);
  EXPECT_EQ(data.validation[0].frame_count(), 40);
  EXPECT_TRUE(data.unseen[0].backbone == whole.backbone.middleRows(321, 40));
}

TEST(HoldBackUnseen, TakesNothingOfWhatIsTooShort) {
  TrainingData data = hold_back_validation({toy_episode(three_segment_arm(), 5, 20, 1)}, 0.1, 1);
  hold_back_unseen(data, 0.1, 1);
  EXPECT_TRUE(data.unseen.empty());
  EXPECT_EQ(data.training.size(), 1U);
}

}  // namespace
}  // namespace limber
