#include <filesystem>
#include <numeric>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/training/episode_slices.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int kArms = 12;
constexpr int kFrames = 24 * 20 + 1;  // of an episode

const ArmDescription& arm() {
  static const ArmDescription arm = three_segment_arm();
  return arm;
}

/// Two episodes of each of kArms toy arms.
const std::vector<Episode>& episodes() {
  static const std::vector<Episode> all = [] {
    std::vector<Episode> made;
    for (int i = 0; i < 2 * kArms; ++i) {
      made.push_back(toy_episode(arm(), 24, 20, static_cast<std::uint64_t>(i),
                                 5.0F + 3.0F * static_cast<float>(i / 2)));
    }
    return made;
  }();
  return all;
}

TrainingData in_memory() {
  TrainingData data;
  data.training = episodes();
  data.validation = {toy_episode(arm(), 40, 20, 99, 20.0F)};
  for (int i = 0; i < 2 * kArms; ++i) {
    data.arms.push_back(i / 2);
  }
  return data;
}

TrainingData in_slices_of(int frames) {
  TrainingData data = in_memory();
  data.training.clear();
  data.slices.frame_counts.assign(2 * kArms, kFrames);
  data.slices.slice_frames = frames;
  data.slices.read = [](std::span<const int> which) {
    std::vector<Episode> some;
    for (const int episode : which) {
      some.push_back(episodes()[static_cast<std::size_t>(episode)]);
    }
    return some;
  };
  return data;
}

TrainingSettings settings() {
  TrainingSettings settings = best_preset();
  set_family_size(settings, 2);
  settings.hidden_units = {16, 16};
  settings.stages = {{4, 16, 3}, {16, 16, 3}};
  return settings;
}

void expect_same(const CompensationModel& one, const CompensationModel& other) {
  ASSERT_EQ(one.layers.size(), other.layers.size());
  for (std::size_t i = 0; i < one.layers.size(); ++i) {
    EXPECT_EQ(one.layers[i].weight, other.layers[i].weight);
    EXPECT_EQ(one.layers[i].bias, other.layers[i].bias);
  }
  EXPECT_EQ(one.family->arms, other.family->arms);
  EXPECT_EQ(one.input.scale, other.input.scale);
  EXPECT_EQ(one.bounds->max_length_m, other.bounds->max_length_m);
}

TEST(EpisodeSlices, HoldEveryEpisodeOnceInOtherPartsEachEpoch) {
  SlicedEpisodes sliced;
  sliced.slice_frames = 100;
  for (int i = 0; i < 200; ++i) {
    sliced.frame_counts.push_back(1 + i % 7);
  }
  const auto slices = slices_of(sliced, 1, 0);
  EXPECT_EQ(slices.size(), 8U) << "794 frames";
  std::vector<int> all;
  for (const std::vector<int>& slice : slices) {
    int frames = 0;
    for (const int episode : slice) {
      frames += sliced.frame_counts[static_cast<std::size_t>(episode)];
    }
    EXPECT_NEAR(frames, 794.0 / 8.0, 7.0) << "an episode is never cut";
    EXPECT_TRUE(std::ranges::is_sorted(slice));
    all.insert(all.end(), slice.begin(), slice.end());
  }
  std::ranges::sort(all);
  std::vector<int> numbers(200);
  std::iota(numbers.begin(), numbers.end(), 0);
  EXPECT_EQ(all, numbers);
  EXPECT_EQ(slices, slices_of(sliced, 1, 0));
  EXPECT_NE(slices, slices_of(sliced, 1, 1));
  EXPECT_NE(slices, slices_of(sliced, 2, 0));
  EXPECT_EQ(slices_of({}, 1, 0).size(), 1U) << "all in memory";
}

TEST(EpisodeSlices, OneSliceIsTrainingInMemoryToTheBit) {
  const TrainingResult memory = train(arm(), in_memory(), settings());
  const TrainingResult one = train(arm(), in_slices_of(2 * kArms * kFrames), settings());
  expect_same(one.model, memory.model);
  EXPECT_EQ(one.curve.back().loss, memory.curve.back().loss);
  EXPECT_EQ(one.model.training.at("training_frames"), memory.model.training.at("training_frames"));
}

TEST(EpisodeSlices, AnyNumberOfThreadsLearnsTheSame) {
  TrainingSettings threads = settings();
  threads.jobs = 1;
  const TrainingResult one = train(arm(), in_slices_of(5 * kFrames), threads);
  threads.jobs = 3;
  expect_same(train(arm(), in_slices_of(5 * kFrames), threads).model, one.model);
}

TEST(EpisodeSlices, AResumedRunIsAnUninterruptedOne) {
  const TrainingResult whole = train(arm(), in_slices_of(5 * kFrames), settings());
  TrainingSettings part = settings();
  part.checkpoint = std::filesystem::path(testing::TempDir()) / "episode_slices.checkpoint";
  part.stop_after_epochs = 4;
  EXPECT_EQ(train(arm(), in_slices_of(5 * kFrames), part).status, TrainingStatus::interrupted);
  part.stop_after_epochs = 0;
  part.resume = true;
  EXPECT_THAT([&] { (void)train(arm(), in_slices_of(6 * kFrames), part); },
              ThrowsMessage<InputError>(HasSubstr("checkpoint")))
      << "of other slices";
  expect_same(train(arm(), in_slices_of(5 * kFrames), part).model, whole.model);
  std::filesystem::remove(part.checkpoint);
}

// Fewer windows to shuffle cost little: slices are random shares of the arms.
TEST(EpisodeSlices, ThreeSlicesLearnAsMuchAsOne) {
  constexpr double kMuchWorse = 1.25;
  TrainingSettings longer = settings();
  longer.stages = {{4, 16, 20}, {16, 16, 20}};
  const double memory = train(arm(), in_memory(), longer).curve.back().loss;
  const TrainingResult three = train(arm(), in_slices_of(8 * kFrames), longer);
  EXPECT_LT(three.curve.back().loss, kMuchWorse * memory);
  EXPECT_LT(three.curve.back().loss, 0.5 * three.curve.front().loss);
}

TEST(EpisodeSlices, ShowARegionAndBoundsThatHoldAllOfThem) {
  const TrainingData data = in_slices_of(4 * kFrames);
  const LearntRegion region = learnt_region_of(data);
  const LearntRegion memory = learnt_region_of(in_memory());
  EXPECT_EQ(region.low_kpa, memory.low_kpa);
  EXPECT_EQ(region.high_kpa, memory.high_kpa);
  const CompensationModel model = train(arm(), data, settings()).model;
  for (const Episode& episode : episodes()) {
    for (int t = 1; t < episode.frame_count(); t += 10) {
      EXPECT_LE(
          region.novelty(episode.pressure_kpa.row(t).transpose(), backbone_at(episode.backbone, t),
                         episode.pressure_kpa.row(t - 1).transpose(),
                         backbone_at(episode.backbone, t - 1)),
          1.2);
    }
  }
  const CompensationModel whole = train(arm(), in_memory(), settings()).model;
  EXPECT_TRUE(
      (model.bounds->max_turn_rad.array() > 0.95F * whole.bounds->max_turn_rad.array()).all());
}

TEST(EpisodeSlices, AreNotMixedWithEpisodesInMemory) {
  TrainingData both = in_slices_of(4 * kFrames);
  both.training = episodes();
  both.arms.clear();
  EXPECT_THAT([&] { (void)train(arm(), both, settings()); },
              ThrowsMessage<InputError>(HasSubstr("expected slices")));
}

}  // namespace
}  // namespace limber
