#include "limber/run/episode_recorder.hpp"

#include <gmock/gmock.h>

#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

// A driver has no newer sample: the frame is one in which nothing was seen, between two samples.
TEST(EpisodeRecorder, ARepeatedSampleIsNoMeasurement) {
  const ArmDescription arm = small_arm();
  EpisodeRecorder recorder(arm);
  ArmState state;
  state.pressure_kpa = Pressures::Zero(2);
  for (const double time_s : {3.0, 3.0, 3.125, 3.125, 3.125, 3.5, 3.5}) {
    state.time_s = time_s;
    state.backbone = Backbone::Constant(arm.point_count(), 3, static_cast<float>(time_s));
    recorder.add(state, Pressures::Zero(2), 0);
  }
  const Episode episode = recorder.finish();
  constexpr double kRoundingS = 1e-12;
  EXPECT_THAT(episode.time_s,
              Pointwise(DoubleNear(kRoundingS), {0.0, 0.0625, 0.125, 0.25, 0.375, 0.5, 0.55}));
  EXPECT_THAT(episode.tracked, ElementsAre(1, 0, 1, 0, 0, 1, 0));
  EXPECT_EQ(episode.backbone(1, 0), 3.0625F);
  EXPECT_EQ(episode.backbone(6, 0), 3.5F);
}

}  // namespace
}  // namespace limber
