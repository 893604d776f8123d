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

/// The same motions at twice the speed.
Episode twice_as_fast(const Episode& episode) {
  std::vector<int> kept;
  for (int t = 0; t < episode.frame_count(); t += 2) {
    kept.push_back(t);
  }
  Episode fast = episode;
  fast.time_s = episode.time_s.head(Eigen::Index(kept.size())).eval();
  fast.pressure_kpa = episode.pressure_kpa(kept, Eigen::all);
  fast.setpoint_kpa = episode.setpoint_kpa(kept, Eigen::all);
  fast.backbone = episode.backbone(kept, Eigen::all);
  fast.motion_index.resize(kept.size());
  return fast;
}

// Toy arms move for a third of the time or more, and always by the same step.
TEST(NovelFrames, SeeMotionsThatAreFasterThanAnyRecorded) {
  constexpr double kMoving = 0.3;
  const ArmDescription arm = three_segment_arm();
  std::vector<Episode> recorded;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    recorded.push_back(toy_episode(arm, 40, 30, seed));
  }
  LearntRegion learnt = learnt_region_of(recorded);
  const Episode other = toy_episode(arm, 40, 30, 50);
  const auto novel_share = [&](const Episode& episode) {
    const NovelFrames found = find_novel_frames(learnt, {episode});
    return double(found.pressures_within.novel + found.pressures_beyond.novel) /
           episode.frame_count();
  };
  EXPECT_LT(novel_share(other), 0.05);
  EXPECT_GT(novel_share(twice_as_fast(other)), kMoving);
  EXPECT_GT(novel_share(twice_as_fast(recorded[0])), kMoving) << "shapes that it knows";
  learnt.joint_change.resize(0);
  EXPECT_LT(novel_share(twice_as_fast(other)), 0.05) << "a region that knows no speed";
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
