#include "limber/training/learnt_region_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "training/toy_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<Episode> toy_episodes(const ArmDescription& arm, int count, std::uint64_t seed) {
  std::vector<Episode> episodes;
  for (int k = 0; k < count; ++k) {
    episodes.push_back(toy_episode(arm, 40, 30, seed + static_cast<std::uint64_t>(k)));
  }
  return episodes;
}

/// The arm with its pressures limited to half of what it can do.
ArmDescription timid(ArmDescription arm) {
  for (Segment& segment : arm.segments) {
    segment.pressure_limit_kpa *= 0.5;
  }
  return arm;
}

bool is_flagged(const LearntRegion& region, const Episode& episode, int t, float bend_rad = 0.0F) {
  Backbone backbone(region.point_count(), 3);
  backbone.reshaped<Eigen::RowMajor>() = episode.backbone.row(t).transpose();
  for (Eigen::Index j = 1; j < backbone.rows(); ++j) {
    backbone(j, 2) += bend_rad * static_cast<float>(j);
  }
  return region.novelty(episode.pressure_kpa.row(t).transpose(), backbone) > 1.0;
}

// 20 frames per second.
TEST(LearntRegionFit, RatesAreThoseThatWereHeldForAWhile) {
  constexpr float kRateRounding = 1e-2F;  // [kPa/s]
  const ArmDescription arm = three_segment_arm();
  Episode episode = toy_episode(arm, 40, 30, 1);
  episode.pressure_kpa.col(0).setZero();
  for (int t = 0; t <= 40; ++t) {
    episode.pressure_kpa(100 + t, 0) = 1.5F * float(t);  // 30 kPa/s for 2 s
    episode.pressure_kpa(141 + t, 0) = 60.0F - 1.0F * float(t);
    episode.pressure_kpa(182 + t, 0) = 20.0F - 0.5F * float(t);
  }
  episode.pressure_kpa(500, 0) = 50.0F;  // a sensor's spike
  const LearntRegion region = learnt_region_of(std::vector<Episode>{episode});
  EXPECT_NEAR(region.steepest_rise_kpa_per_s[0], 30.0F, kRateRounding);
  EXPECT_NEAR(region.steepest_fall_kpa_per_s[0], 20.0F, kRateRounding);
  EXPECT_EQ(region.high_kpa[0], std::max(60.0F, episode.setpoint_kpa.col(0).maxCoeff()));
  const LearntRegion twice = widened_by(region, {episode});
  EXPECT_EQ(twice.steepest_rise_kpa_per_s[0], region.steepest_rise_kpa_per_s[0]);
}

TEST(LearntRegionFit, RangesAreThoseOfPressuresAndSetPoints) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> episodes = toy_episodes(arm, 2, 1);
  const LearntRegion region = learnt_region_of(episodes);
  for (int i = 0; i < 3; ++i) {
    float low = 1e9F, high = -1e9F;
    for (const Episode& episode : episodes) {
      for (int t = 0; t < episode.frame_count(); ++t) {
        for (const float kpa : {episode.pressure_kpa(t, i), episode.setpoint_kpa(t, i)}) {
          low = std::min(low, kpa);
          high = std::max(high, kpa);
        }
      }
    }
    EXPECT_EQ(region.low_kpa[i], low);
    EXPECT_EQ(region.high_kpa[i], high);
  }
}

// Toy pressures change by 5 kPa a frame while they change; a spike of a sensor says nothing.
TEST(LearntRegionFit, ChangesOverAFrameAreThoseThatHappenOften) {
  Episode episode = toy_episode(three_segment_arm(), 40, 30, 1);
  episode.pressure_kpa(500, 0) += 90.0F;
  const LearntRegion region = learnt_region_of(std::vector<Episode>{episode});
  ASSERT_EQ(region.joint_change.size(), 48);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(region.joint_change[i], 5.0F * float(1.0 + kAxisWidening) - 1e-4F);
    EXPECT_LT(region.joint_change[i], 10.0F);
  }
  EXPECT_GT(region.joint_change.minCoeff(), 0.0F);
  episode.tracked.assign(static_cast<std::size_t>(episode.frame_count()), 1);
  for (std::size_t t = 0; t < episode.tracked.size(); t += 2) {
    episode.tracked[t] = 0;
  }
  EXPECT_EQ(learnt_region_of(std::vector<Episode>{episode}).joint_change.size(), 0)
      << "no two frames follow each other";
}

TEST(LearntRegionFit, AxesAreOrthonormal) {
  constexpr float kRounding = 1e-5F;
  const LearntRegion region = learnt_region_of(toy_episodes(three_segment_arm(), 2, 1));
  const Eigen::MatrixXf product = region.axes * region.axes.transpose();
  EXPECT_TRUE(product.isIdentity(kRounding));
  EXPECT_NO_THROW(validate(region, 3, 16, "m"));
}

TEST(LearntRegionFit, HoldsWhatItLearntFromAndLittleElse) {
  const ArmDescription arm = three_segment_arm();
  // Much data: a set point of the next recordings then seldom lies beyond all of these.
  const std::vector<Episode> training = toy_episodes(timid(arm), 16, 1);
  const LearntRegion region = learnt_region_of(training);
  int more = 0, more_flagged = 0;
  for (const Episode& episode : toy_episodes(timid(arm), 2, 50)) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      ++more;
      more_flagged += is_flagged(region, episode, t) ? 1 : 0;
    }
  }
  EXPECT_LE(more_flagged, 0.05 * more);
  int beyond = 0, beyond_flagged = 0;
  for (const Episode& episode : toy_episodes(arm, 2, 70)) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      const Pressures kpa = episode.pressure_kpa.row(t);
      if ((kpa.array() < region.low_kpa.array()).any() ||
          (kpa.array() > region.high_kpa.array()).any()) {
        ++beyond;
        beyond_flagged += is_flagged(region, episode, t) ? 1 : 0;
      }
    }
  }
  EXPECT_GE(beyond_flagged, 0.9 * beyond);
  EXPECT_GT(beyond, 1000);
  for (int t = 0; t < training[0].frame_count(); t += 7) {
    EXPECT_FALSE(is_flagged(region, training[0], t));
  }
}

// Pressures within the recorded range, but every gap bent as no pressure bends it.
TEST(LearntRegionFit, FlagsABackboneThatPressuresDoNotExplain) {
  const ArmDescription arm = three_segment_arm();
  const LearntRegion region = learnt_region_of(toy_episodes(arm, 4, 1));
  const Episode episode = toy_episode(arm, 40, 30, 90);
  int flagged = 0;
  for (int t = 0; t < episode.frame_count(); ++t) {
    flagged += is_flagged(region, episode, t, 0.15F) ? 1 : 0;
  }
  EXPECT_GE(flagged, 0.9 * episode.frame_count());
}

TEST(LearntRegionFit, WideningByWhatIsHeldChangesNothing) {
  const std::vector<Episode> episodes = toy_episodes(three_segment_arm(), 2, 1);
  const LearntRegion region = learnt_region_of(episodes);
  const LearntRegion same = widened_by(region, episodes);
  EXPECT_TRUE(same.axis_low == region.axis_low && same.axis_high == region.axis_high);
  EXPECT_TRUE(same.low_kpa == region.low_kpa && same.high_kpa == region.high_kpa);
  EXPECT_TRUE(same.joint_change == region.joint_change);
}

// A model that is evaluated on a wider recording has not learnt what lies beyond its own.
TEST(LearntRegionFit, ShapesOfOthersWidenNoPressures) {
  const ArmDescription arm = three_segment_arm();
  const LearntRegion region = learnt_region_of(toy_episodes(timid(arm), 2, 1));
  const std::vector<Episode> wide = toy_episodes(arm, 2, 60);
  const LearntRegion with_shapes = with_shapes_of(region, wide);
  EXPECT_TRUE(with_shapes.low_kpa == region.low_kpa && with_shapes.high_kpa == region.high_kpa);
  EXPECT_TRUE(with_shapes.steepest_rise_kpa_per_s == region.steepest_rise_kpa_per_s);
  EXPECT_TRUE(with_shapes.joint_change.head(3) == region.joint_change.head(3));
  int inside = 0;
  int outside = 0;
  for (int t = 0; t < wide[0].frame_count(); ++t) {
    const Pressures kpa = wide[0].pressure_kpa.row(t);
    const bool held = (kpa.array() >= region.low_kpa.array()).all() &&
                      (kpa.array() <= region.high_kpa.array()).all();
    if (held) {
      EXPECT_FALSE(is_flagged(with_shapes, wide[0], t)) << t;
    }
    (held ? inside : outside) += 1;
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 100);
}

TEST(LearntRegionFit, FineTuningHoldsOldAndNew) {
  const ArmDescription arm = three_segment_arm();
  const std::vector<Episode> old_data = toy_episodes(timid(arm), 2, 1);
  const std::vector<Episode> new_data = toy_episodes(arm, 1, 60);
  const LearntRegion start = learnt_region_of(old_data);
  const LearntRegion tuned = learnt_region_of(TrainingData{new_data, {}}, &start);
  EXPECT_TRUE(tuned.axes == start.axes);
  for (const Episode& episode : {old_data[0], new_data[0]}) {
    for (int t = 0; t < episode.frame_count(); t += 5) {
      EXPECT_FALSE(is_flagged(tuned, episode, t));
    }
  }
}

TEST(LearntRegionFit, RefusesRecordingsInWhichTheArmWasNeverSeen) {
  Episode episode = toy_episode(three_segment_arm(), 2, 10, 1);
  episode.tracked.assign(21, 0);
  EXPECT_THAT([&] { (void)learnt_region_of({episode}); },
              ThrowsMessage<InputError>(HasSubstr("the arm was tracked in no frame")));
}

}  // namespace
}  // namespace limber
