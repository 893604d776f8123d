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
  PressureLossWatch watch(kValves, kFrame_s);
  RandomStream random(3, 0);
  for (int frame = 0; frame < kFrames; ++frame) {
    const float t = 0.05F * static_cast<float>(frame);
    const Pressures expected_kpa{{40.0F * std::sin(2.0F * t), 30.0F + 20.0F * std::sin(3.0F * t)}};
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
    EXPECT_GE(losses[0].time_s, kFrom * kFrame_s);
    EXPECT_LT(losses[0].time_s, kFrom * kFrame_s + 1.0);
  }
}

TEST(PressureLoss, NoiseAndSmallErrorsOfTheValvesAreNone) {
  EXPECT_TRUE(found(1.0, 2.0).empty());
  EXPECT_TRUE(found(0.98, 0.0).empty());
  EXPECT_TRUE(found(1.1, 0.0).empty()) << "more than expected";
}

TEST(PressureLoss, IdealValvesTellNothing) {
  const ValveModel ideal(kArm, {});
  PressureLossWatch watch(ideal, kFrame_s);
  watch.observe(Pressures::Constant(2, 50.0F), Pressures::Constant(2, 10.0F));
  EXPECT_TRUE(watch.found().empty());
}

}  // namespace
}  // namespace limber
