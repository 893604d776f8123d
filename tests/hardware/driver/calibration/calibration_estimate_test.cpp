#include "limber/hardware/calibration_estimate.hpp"

#include <cstdlib>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "limber/common/data_folder.hpp"
#include "simulated_rig.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

// The figures of docs/hardware.md.
constexpr double kPositionM = 1e-3;
constexpr double kHeadingRad = 0.01;
constexpr double kDelayS = 5e-3;
constexpr int kCasesHere = 8;  // all 200 with LIMBER_CALIBRATION_CASES=200: ctest -L soak

ArmDescription arm_of(std::uint64_t seed) {
  ArmDescription arm;
  arm.name = "random";
  arm.frame_rate_hz = 20.0;
  arm.pressure_rate_limit_kpa_per_s = 100.0;
  arm.actuator_radius_m = 0.006;
  RandomStream chance(seed, 7);
  const auto segments = 2 + chance.index(3);
  for (std::uint32_t s = 0; s < segments; ++s) {
    Segment segment;
    segment.length_m = chance.uniform(0.15, 0.3);
    segment.width_m = chance.uniform(0.017, 0.05);
    segment.gaps = 3 + static_cast<int>(chance.index(4));
    segment.pressure_limit_kpa = PressureLimits(100.0);
    arm.segments.push_back(segment);
  }
  return arm;
}

CalibrationEstimate calibrated(const ArmDescription& arm, const Misassembly& wrong, Flaw flaw,
                               std::uint64_t seed) {
  SimulatedRig rig(arm, wrong, flaw, seed);
  const CalibrationLog log = record_calibration(arm, calibration_pulse_kpa(arm), rig.rig());
  OperatorAnswer answer;
  if (seed % 2 == 0) {
    answer.mirrored = wrong.truth.tracker->mirrored;
  } else {  // the operator sees where the timing step's channel bends the arm
    for (const WireChannel& valve : wrong.truth.valves) {
      if (valve.channel == log.timing.channel) {
        answer.bends_right = valve.sign > 0.0;
      }
    }
  }
  return estimate_calibration(arm, log, answer);
}

/// Shapes through the wrong wire and the calibration come back.
void expect_shapes(const ArmDescription& arm, const WireCalibration& found,
                   const Misassembly& wrong) {
  for (const float bend : {0.0F, 0.3F, -0.2F}) {
    Backbone backbone(arm.point_count(), 3);
    for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
      const auto t = static_cast<float>(i);
      backbone.row(i) << 0.04F * t, 0.01F * bend * t * t, 0.2F * bend * t;
    }
    ArmState state;
    state.pressure_kpa = Pressures::Zero(arm.segment_count());
    state.backbone = backbone;
    const ArmState back = found.from_wire(wrong.truth.to_wire(state));
    // Position at the base; heading everywhere. Farther out a heading's error moves a plate too.
    EXPECT_LT((back.backbone->row(0) - backbone.row(0)).head<2>().norm(), kPositionM);
    EXPECT_LT((*back.backbone - backbone).col(2).cwiseAbs().maxCoeff(), kHeadingRad);
  }
}

int case_count() {
  const char* asked = std::getenv("LIMBER_CALIBRATION_CASES");
  return asked != nullptr ? std::atoi(asked) : kCasesHere;
}

// 200 of these: frames, permutations, signs, units and delays come back.
TEST(CalibrationEstimate, RecoversWhatWasPutTogetherWrongly) {
  double worst_m = 0.0;
  double worst_rad = 0.0;
  double worst_s = 0.0;
  int refused = 0;
  for (int k = 0; k < case_count(); ++k) {
    SCOPED_TRACE(k);
    const auto seed = static_cast<std::uint64_t>(k);
    const ArmDescription arm = arm_of(seed);
    const Misassembly wrong = draw_misassembly(arm, seed);
    const CalibrationEstimate found = calibrated(arm, wrong, Flaw::none, seed);
    if (!found.refusal.empty()) {
      ++refused;
      ADD_FAILURE() << found.refusal;
      continue;
    }
    const WireCalibration& got = found.calibration;
    EXPECT_EQ(got.valves, wrong.truth.valves);
    EXPECT_EQ(got.sensors, wrong.truth.sensors);
    for (std::size_t c = 0; c < got.zero_kpa.size(); ++c) {
      EXPECT_NEAR(got.zero_kpa[c], wrong.truth.zero_kpa[c], 0.02);
    }
    EXPECT_EQ(got.tracker->metres_per_unit, wrong.truth.tracker->metres_per_unit);
    EXPECT_EQ(got.tracker->mirrored, wrong.truth.tracker->mirrored);
    EXPECT_DOUBLE_EQ(got.tracker->radians_per_unit, wrong.truth.tracker->radians_per_unit);
    expect_shapes(arm, got, wrong);
    const double off_m = std::hypot(got.tracker->base.x_m - wrong.truth.tracker->base.x_m,
                                    got.tracker->base.y_m - wrong.truth.tracker->base.y_m);
    const double off_rad = std::abs(std::remainder(
        got.tracker->base.theta_rad - wrong.truth.tracker->base.theta_rad, 2 * std::numbers::pi));
    const double off_s = std::abs(got.clocks.shape_delay->value_s - wrong.tracker_latency_s);
    EXPECT_LT(off_m, kPositionM);
    EXPECT_LT(off_rad, kHeadingRad);
    EXPECT_LT(off_s, kDelayS);
    EXPECT_NEAR(got.clocks.driver->value_s, -wrong.driver_ahead_s, kDelayS);
    EXPECT_NEAR(got.clocks.tracker->value_s, -wrong.tracker_ahead_s, kDelayS);
    EXPECT_LE(got.clocks.driver->low_s, -wrong.driver_ahead_s + 1e-3);
    EXPECT_GE(got.clocks.driver->high_s, -wrong.driver_ahead_s - 1e-3);
    worst_m = std::max(worst_m, off_m);
    worst_rad = std::max(worst_rad, off_rad);
    worst_s = std::max(worst_s, off_s);
    if (std::getenv("LIMBER_CALIBRATION_CASES") != nullptr) {
      std::printf("%d: %.2f mm (±%.2f), %.4f rad (±%.4f), %.1f ms (±%.1f)\n", k, 1e3 * off_m,
                  1e3 * got.tracker->position_interval_m, off_rad,
                  got.tracker->heading_interval_rad, 1e3 * off_s,
                  500.0 * (got.clocks.shape_delay->high_s - got.clocks.shape_delay->low_s));
    }
  }
  std::printf("%d cases, %d refused; at worst %.2f mm, %.4f rad, %.1f ms off\n", case_count(),
              refused, 1e3 * worst_m, worst_rad, 1e3 * worst_s);
}

TEST(CalibrationEstimate, RefusesWhatNoCalibrationPutsRight) {
  const ArmDescription arm = arm_of(3);
  const Misassembly wrong = draw_misassembly(arm, 3);
  const auto refusal = [&](Flaw flaw) { return calibrated(arm, wrong, flaw, 3).refusal; };
  EXPECT_THAT(refusal(Flaw::crossed_hoses), HasSubstr("hoses are crossed between segments"));
  EXPECT_THAT(refusal(Flaw::dead_channel), HasSubstr("channel 1 at 10 kPa moved nothing"));
  EXPECT_THAT(refusal(Flaw::millibar), HasSubstr("the driver sends mbar"));
  EXPECT_THAT(refusal(Flaw::bodies_reversed), HasSubstr("come in another order"));
  EXPECT_THAT(refusal(Flaw::bodies_swapped), HasSubstr("come in another order"));
  EXPECT_THAT(refusal(Flaw::other_arm), HasSubstr("no unit (m, cm, mm, in) fits"));
  EXPECT_THAT(refusal(Flaw::untracked), HasSubstr("nothing tracks the arm"));
}

}  // namespace
}  // namespace limber
