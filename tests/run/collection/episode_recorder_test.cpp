#include "limber/run/episode_recorder.hpp"

#include <optional>
#include <utility>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "support/fake_arm.hpp"
#include "support/space_arm.hpp"

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

/// All plates turned about z.
SpaceBackbone turned(const ArmDescription& arm, double angle_rad, float sign) {
  const Eigen::Quaterniond rotation(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()));
  SpaceBackbone shape = SpaceBackbone::Zero(arm.point_count(), kSpacePoseSize);
  shape.rightCols<4>().rowwise() = sign * rotation.coeffs().cast<float>().transpose();
  return shape;
}

// q and −q are one rotation, and a tracker may send either.
TEST(EpisodeRecorder, ALostRotationLiesBetweenItsNeighboursWhateverTheirSigns) {
  constexpr float kRounding = 1e-6F;  // of a unit quaternion's numbers
  const ArmDescription arm = testing_support::space_arm();
  EpisodeRecorder recorder(arm);
  ArmState state;
  state.pressure_kpa = Pressures::Zero(arm.channel_count());
  const auto add = [&](std::optional<SpaceBackbone> shape) {
    state.space_backbone = std::move(shape);
    recorder.add(state, state.pressure_kpa, 0);
    state.time_s += arm.frame_period_s();
  };
  add(turned(arm, 0.2, -1.0F));
  add(std::nullopt);
  add(turned(arm, 0.4, 1.0F));
  add(turned(arm, 0.6, -1.0F));
  const Episode episode = recorder.finish();
  EXPECT_THAT(episode.tracked, ElementsAre(1, 0, 1, 1));
  constexpr double kAnglesRad[] = {0.2, 0.3, 0.4, 0.6};
  for (Eigen::Index t = 0; t < 4; ++t) {
    const SpaceBackbone wanted = turned(arm, kAnglesRad[t], -1.0F);
    const Eigen::Map<const SpaceBackbone> shape(episode.backbone.row(t).data(), arm.point_count(),
                                                kSpacePoseSize);
    EXPECT_LT((shape - wanted).cwiseAbs().maxCoeff(), kRounding) << t;
  }
}

}  // namespace
}  // namespace limber
