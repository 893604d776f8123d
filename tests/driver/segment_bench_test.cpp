#include "limber/driver/segment_bench.hpp"

#include <gmock/gmock.h>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kStrain = 1e-5;       // float32 shapes
constexpr double kShareOfFull = 0.06;  // hinges for arcs, and what friction leaves

ArmDescription one_segment() {
  ArmDescription arm;
  arm.name = "one";
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  arm.segments.resize(1);
  Segment& segment = arm.segments.front();
  segment.length_m = 0.235;
  segment.width_m = 0.05;
  segment.gaps = 5;
  segment.pressure_limit_kpa = PressureLimits(100.0);
  segment.strain_polynomial = {0.001638291, 3.810475e-05, -5.205297e-07, 1.797926e-09};
  return arm;
}

// (3), (4): of the no-load model's shapes, the inflated side's strain is -P(p), the other's 0.
TEST(SideStrain, IsThatOfTheNoLoadModel) {
  const ArmDescription arm = one_segment();
  const NoLoadModel model(arm);
  const auto shape = [&](float kpa) {
    Backbone backbone(arm.point_count(), 3);
    const Eigen::VectorXf pressure = Eigen::VectorXf::Constant(1, kpa);
    model.backbone(Eigen::Ref<const Eigen::VectorXf>(pressure), Eigen::Ref<Backbone>(backbone));
    return backbone;
  };
  for (const float kpa : {20.0F, 60.0F, 100.0F}) {
    for (const float side : {1.0F, -1.0F}) {
      const Backbone bent = shape(side * kpa);
      EXPECT_NEAR(side_strain(shape(0.0F), bent, 0.05, side), -model.strain(0, kpa), kStrain);
      EXPECT_NEAR(side_strain(shape(0.0F), bent, 0.05, -side), 0.0, kStrain);
    }
  }
}

// On a free virtual segment without friction: what its sides are strained by in truth.
TEST(MeasureSegment, FindsTheStrainOfAFreeSegment) {
  ArmDescription arm = one_segment();
  change_virtual_arm(arm, [](VirtualArmParameters& p) {
    p.friction_coefficient = 0.0;
    p.hysteresis_fraction = 0.0;
    p.hysteresis_floor_n = 0.0;
  });
  VirtualArm driver(arm);
  Episode episode;
  const auto points = measure_segment(arm, PressureLimits(100.0), 5, driver, episode);
  ASSERT_EQ(points.size(), 1U + 2U * 9U);
  VirtualArm settled(arm);
  settled.settle(Pressures::Constant(1, 100.0F), 5.0);
  const double full = settled.right_strain(0);
  EXPECT_LT(full, -0.03);
  EXPECT_NEAR(points[5].pressure_kpa, 100.0, 1.0);
  EXPECT_NEAR(points[5].strain, full, kShareOfFull * std::abs(full));
  EXPECT_EQ(episode.frame_count(), static_cast<int>(episode.time_s.size()));
  EXPECT_GT(episode.frame_count(), 19 * 20);
}

TEST(MeasureSegment, RefusesAWholeArm) {
  ArmDescription arm = one_segment();
  arm.segments.push_back(arm.segments.front());
  VirtualArm driver(arm);
  Episode episode;
  EXPECT_THAT([&] { measure_segment(arm, PressureLimits(100.0), 5, driver, episode); },
              ThrowsMessage<InputError>(HasSubstr("limber characterize --recording")));
}

}  // namespace
}  // namespace limber
