#include "estimate/pressure_loss.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr double kFrame_s = 0.05;
constexpr int kFrames = 200;
constexpr int kFrom = 80;
const ArmDescription kArm = small_arm();
const ValveModel kValves(kArm,
                         {true,
                          std::vector<SegmentValves>(2, {{0.1, 100.0}, {0.1, 100.0}, 0.0, 0.2})});

/// Of two segments, of which the second keeps only a share from a frame on; as measured with noise.
std::vector<PressureLoss> found(double kept, double noise_kpa) {
  PressureLossWatch watch(kArm, kValves);
  RandomStream random(3, 0);
  for (int frame = 0; frame < kFrames; ++frame) {
    const float t = 0.05F * static_cast<float>(frame);
    const Pressures expected_kpa{{40.0F * std::sin(2.0F * t), 50.0F + 15.0F * std::sin(3.0F * t)}};
    Pressures measured_kpa = expected_kpa;
    measured_kpa[1] *= frame < kFrom ? 1.0F : static_cast<float>(kept);
    for (float& kpa : measured_kpa) {
      kpa += static_cast<float>(noise_kpa * random.normal());
    }
    watch.observe(expected_kpa, measured_kpa);
  }
  return watch.found();
}

TEST(PressureLoss, IsNoticedWithinASecondWithItsShare) {
  for (const double noise_kpa : {0.0, 0.3}) {
    const std::vector<PressureLoss> losses = found(0.9, noise_kpa);
    ASSERT_EQ(losses.size(), 1U) << noise_kpa;
    EXPECT_EQ(losses[0].segment, 1);
    EXPECT_NEAR(losses[0].share, 0.1, 0.01);
    EXPECT_GE(losses[0].noticed_s, kFrom * kFrame_s);
    EXPECT_LE(losses[0].noticed_s, kFrom * kFrame_s + 1.0 + 1e-9);
  }
}

TEST(PressureLoss, NoiseAndSmallErrorsOfTheValvesAreNone) {
  EXPECT_TRUE(found(1.0, 2.0).empty());
  EXPECT_TRUE(found(0.98, 0.0).empty());
  EXPECT_TRUE(found(1.1, 0.0).empty()) << "more than expected";
}

/// Ramps of so many kPa per frame from 0, then held; measured through other valves than expected.
std::vector<PressureLoss> found_on_ramp(double kpa_per_frame, const SegmentValves& truth,
                                        double dead_band_kpa, double offset_kpa = 0.0) {
  const ValveModel expected(kArm, {true, std::vector<SegmentValves>(
                                             2, {{0.1, 300.0}, {0.1, 300.0}, 0.0, dead_band_kpa})});
  const ValveModel real(kArm, {true, std::vector<SegmentValves>(2, truth)});
  PressureLossWatch watch(kArm, expected);
  Eigen::VectorXf state = expected.settled_state(Pressures::Zero(2));
  Eigen::VectorXf real_state = real.settled_state(Pressures::Zero(2));
  for (int frame = 0; frame < 60; ++frame) {
    const double kpa = std::min(60.0, kpa_per_frame * frame);
    const Pressures setpoint_kpa = Pressures::Constant(2, static_cast<float>(kpa));
    expected.step(setpoint_kpa, state);
    real.step(setpoint_kpa, real_state);
    watch.observe(state.head(2),
                  real_state.head(2) - Pressures::Constant(2, static_cast<float>(offset_kpa)));
  }
  return watch.found();
}

TEST(PressureLoss, SlowerValvesAndOffsetsAreNone) {
  for (const double kpa_per_frame : {1.0, 2.0, 3.0, 5.0}) {
    for (const double dead_band_kpa : {0.0, 0.2}) {
      for (const SegmentValves& truth :
           {SegmentValves{{0.12, 300.0}, {0.12, 300.0}, 0.0, dead_band_kpa},
            SegmentValves{{0.15, 300.0}, {0.15, 300.0}, 0.0, dead_band_kpa},
            SegmentValves{{0.1, 300.0}, {0.1, 300.0}, 0.015, dead_band_kpa}}) {
        EXPECT_TRUE(found_on_ramp(kpa_per_frame, truth, dead_band_kpa).empty())
            << kpa_per_frame << " kPa per frame, " << truth.inflating.time_constant_s << " s, "
            << truth.dead_time_s << " s, " << dead_band_kpa << " kPa";
      }
      const SegmentValves same{{0.1, 300.0}, {0.1, 300.0}, 0.0, dead_band_kpa};
      EXPECT_TRUE(found_on_ramp(kpa_per_frame, same, dead_band_kpa, 2.0).empty()) << "an offset";
    }
  }
}

}  // namespace
}  // namespace limber
