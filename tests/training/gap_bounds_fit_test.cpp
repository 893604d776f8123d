#include "limber/training/gap_bounds_fit.hpp"

#include <gmock/gmock.h>

#include "training/toy_arm.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-6;  // [m, rad]

/// A straight row of plates whose gap 0 is 50 mm long, or longer in a few frames, and turns by
/// ±0.2 rad.
Episode gap_episode(int frames, int broken) {
  Episode episode;
  episode.time_s.setLinSpaced(frames, 0.0, 0.05 * (frames - 1));
  episode.pressure_kpa.setZero(frames, 1);
  episode.setpoint_kpa = episode.pressure_kpa;
  episode.backbone.setZero(frames, 6);
  for (int t = 0; t < frames; ++t) {
    episode.backbone(t, 3) = t < broken ? 5.0F : 0.04F + 0.02F * static_cast<float>(t % 2);
    episode.backbone(t, 5) = t % 3 == 0 ? 0.2F : -0.2F;
  }
  return episode;
}

TEST(GapBoundsOf, IsWhatWasRecordedAndAQuarterOfItsRange) {
  const GapBounds bounds = gap_bounds_of({gap_episode(3000, 0)});
  ASSERT_EQ(bounds.min_length_m.size(), 1);
  EXPECT_NEAR(bounds.min_length_m[0], 0.04 - kMargin * 0.02, kRounding);
  EXPECT_NEAR(bounds.max_length_m[0], 0.06 + kMargin * 0.02, kRounding);
  EXPECT_NEAR(bounds.min_turn_rad[0], -0.2 - kMargin * 0.4, kRounding);
  EXPECT_NEAR(bounds.max_turn_rad[0], 0.2 + kMargin * 0.4, kRounding);
}

TEST(GapBoundsOf, AFewBrokenOrUntrackedFramesDoNotWidenIt) {
  const GapBounds bounds = gap_bounds_of({gap_episode(3000, 2)});
  EXPECT_NEAR(bounds.max_length_m[0], 0.06 + kMargin * 0.02, kRounding);
  Episode untracked = gap_episode(3000, 500);
  untracked.tracked.assign(3000, 1);
  std::fill_n(untracked.tracked.begin(), 500, 0);
  EXPECT_NEAR(gap_bounds_of({untracked}).max_length_m[0], 0.06 + kMargin * 0.02, kRounding);
}

TEST(GapBoundsOf, WhatHardlyMovesHasRoomAllTheSame) {
  Episode still = gap_episode(100, 0);
  still.backbone.col(3).setConstant(0.05F);
  still.backbone.col(5).setZero();
  const GapBounds bounds = gap_bounds_of({still});
  EXPECT_NEAR(bounds.min_length_m[0], 0.05 * (1.0 - kMinLengthMargin), kRounding);
  EXPECT_NEAR(bounds.max_length_m[0], 0.05 * (1.0 + kMinLengthMargin), kRounding);
  EXPECT_NEAR(bounds.max_turn_rad[0], kMinTurnMargin_rad, kRounding);
  still.backbone.setZero();
  EXPECT_GT(gap_bounds_of({still}).min_length_m[0], 0.0F);
}

}  // namespace
}  // namespace limber
