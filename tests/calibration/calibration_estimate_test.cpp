#include "limber/calibration/calibration_estimate.hpp"

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
constexpr double kRoundingS = 1e-9;
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

struct Calibrated {
  CalibrationEstimate known;    ///< with the base's marker body where it was built
  CalibrationEstimate unknown;  ///< without
};

Calibrated calibrated(const ArmDescription& arm, const Misassembly& wrong, Flaw flaw,
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
  Calibrated result;
  result.unknown = estimate_calibration(arm, log, answer);
  const Pose& marker = wrong.truth.tracker->marker_offsets.front();
  answer.base_marker_m = Eigen::Vector2d(marker.x_m, marker.y_m);
  result.known = estimate_calibration(arm, log, answer);
  return result;
}

double position_error_m(const WireCalibration& found, const Misassembly& wrong) {
  return std::hypot(found.tracker->base.x_m - wrong.truth.tracker->base.x_m,
                    found.tracker->base.y_m - wrong.truth.tracker->base.y_m);
}

double heading_error_rad(const WireCalibration& found, const Misassembly& wrong) {
  return std::abs(std::remainder(
      found.tracker->base.theta_rad - wrong.truth.tracker->base.theta_rad, 2 * std::numbers::pi));
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

/// What is found whatever is known of the base.
void expect_wire(const WireCalibration& found, const Misassembly& wrong) {
  EXPECT_EQ(found.valves, wrong.truth.valves);
  EXPECT_EQ(found.sensors, wrong.truth.sensors);
  for (std::size_t c = 0; c < found.zero_kpa.size(); ++c) {
    EXPECT_NEAR(found.zero_kpa[c], wrong.truth.zero_kpa[c], 0.02);
  }
  EXPECT_EQ(found.tracker->metres_per_unit, wrong.truth.tracker->metres_per_unit);
  EXPECT_EQ(found.tracker->mirrored, wrong.truth.tracker->mirrored);
  EXPECT_DOUBLE_EQ(found.tracker->radians_per_unit, wrong.truth.tracker->radians_per_unit);
  EXPECT_NEAR(found.clocks.shape_delay->value_s, wrong.tracker_latency_s, kDelayS);
  EXPECT_NEAR(found.clocks.driver->value_s, -wrong.driver_ahead_s, kDelayS);
  EXPECT_NEAR(found.clocks.tracker->value_s, -wrong.tracker_ahead_s, kDelayS);
  EXPECT_LE(found.clocks.driver->low_s, -wrong.driver_ahead_s + kRoundingS);
  EXPECT_GE(found.clocks.driver->high_s, -wrong.driver_ahead_s - kRoundingS);
  EXPECT_LE(found.clocks.tracker->low_s, -wrong.tracker_ahead_s);
}

/// What the cases were off by at worst.
struct Worst {
  double position_m = 0.0;
  double heading_rad = 0.0;
  double delay_s = 0.0;

  void note(const WireCalibration& found, const Misassembly& wrong) {
    position_m = std::max(position_m, position_error_m(found, wrong));
    heading_rad = std::max(heading_rad, heading_error_rad(found, wrong));
    delay_s =
        std::max(delay_s, std::abs(found.clocks.shape_delay->value_s - wrong.tracker_latency_s));
  }
  void print(const char* what) const {
    std::printf("%s: at worst %.2f mm, %.4f rad, %.1f ms off\n", what, 1e3 * position_m,
                heading_rad, 1e3 * delay_s);
  }
};

// 200 of these: frames, permutations, signs, units and delays come back, or are refused.
TEST(CalibrationEstimate, RecoversWhatWasPutTogetherWrongly) {
  const CalibrationTolerance tolerance;
  Worst with_marker;
  Worst without;
  int refused = 0;
  int refused_with_marker = 0;
  for (int k = 0; k < case_count(); ++k) {
    SCOPED_TRACE(k);
    const auto seed = static_cast<std::uint64_t>(k);
    const ArmDescription arm = arm_of(seed);
    const Misassembly wrong = draw_misassembly(arm, seed);
    const Calibrated found = calibrated(arm, wrong, Flaw::none, seed);
    if (found.known.refusal.empty()) {
      expect_wire(found.known.calibration, wrong);
      expect_shapes(arm, found.known.calibration, wrong);
      with_marker.note(found.known.calibration, wrong);
    } else {
      EXPECT_THAT(found.known.refusal, HasSubstr("the base's frame is known to"));
      ++refused_with_marker;
    }
    if (!found.unknown.refusal.empty()) {
      EXPECT_THAT(found.unknown.refusal, HasSubstr("Say where the base's marker body sits"));
      ++refused;
      continue;
    }
    expect_wire(found.unknown.calibration, wrong);
    without.note(found.unknown.calibration, wrong);
  }
  with_marker.print("base marker known");
  without.print("base marker unknown");
  std::printf("%d cases; refused: %d with the base marker known, %d without\n", case_count(),
              refused_with_marker, refused);
  EXPECT_LT(with_marker.position_m, kPositionM);
  EXPECT_LT(with_marker.heading_rad, kHeadingRad);
  EXPECT_LT(without.position_m, tolerance.position_m);
  EXPECT_LT(without.heading_rad, tolerance.heading_rad);
  EXPECT_LE(refused_with_marker, 1 + case_count() / 20);
  EXPECT_LE(refused, 1 + case_count() / 4);
}

TEST(CalibrationEstimate, RefusesWhatNoCalibrationPutsRight) {
  const ArmDescription arm = arm_of(3);
  const Misassembly wrong = draw_misassembly(arm, 3);
  const auto refusal = [&](Flaw flaw) { return calibrated(arm, wrong, flaw, 3).known.refusal; };
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
