#include <gtest/gtest.h>

#include "limber/training/evaluation.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

std::vector<Episode> episodes_of(const ArmDescription& arm, std::uint64_t seed) {
  return {toy_episode(arm, 40, 30, seed), toy_episode(arm, 40, 30, seed + 1)};
}

TEST(NovelFrames, AreFewOfTheSameKindAndNearlyAllBeyondTheRecordedPressures) {
  const ArmDescription arm = three_segment_arm();
  ArmDescription timid = arm;
  for (Segment& segment : timid.segments) {
    segment.pressure_limit_kpa *= 0.5;
  }
  const LearntRegion learnt = learnt_region_of(episodes_of(timid, 1));

  const NovelFrames same = find_novel_frames(learnt, episodes_of(timid, 11));
  EXPECT_GT(same.pressures_within.frames, 2000);
  EXPECT_LE(same.pressures_within.novel, same.pressures_within.frames / 20);

  const NovelFrames bold = find_novel_frames(learnt, episodes_of(arm, 21));
  EXPECT_GT(bold.pressures_beyond.frames, 1000);
  EXPECT_GE(10 * bold.pressures_beyond.novel, 9 * bold.pressures_beyond.frames);
}

TEST(NovelFrames, CountTrackedFramesOnce) {
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> episodes = episodes_of(arm, 1);
  const LearntRegion learnt = learnt_region_of(episodes);
  const auto frames_in = [&] {
    const NovelFrames found = find_novel_frames(learnt, episodes);
    return found.pressures_within.frames + found.pressures_beyond.frames;
  };
  EXPECT_EQ(frames_in(), episodes[0].frame_count() + episodes[1].frame_count());
  episodes[0].tracked.assign(static_cast<std::size_t>(episodes[0].frame_count()), 0);
  EXPECT_EQ(frames_in(), episodes[1].frame_count());
}

}  // namespace
}  // namespace limber
