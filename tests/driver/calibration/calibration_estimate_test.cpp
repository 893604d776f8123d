#include "limber/driver/calibration_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>

#include "limber/arm/arm_description.hpp"
#include "simulated_rig.hpp"
#include "src/driver/calibration/seen_poses.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

// The figures of docs/hardware.md.
constexpr double kPositionM = 1e-3;
constexpr double kHeadingRad = 0.01;
constexpr double kTiltRad = 0.005;  // of the plane of bodies in 3D
constexpr double kDelayS = 5e-3;
constexpr double kRoundingS = 1e-9;
constexpr int kCasesHere = 8;  // all 200 with LIMBER_CALIBRATION_CASES=200: ctest -L soak

TEST(CalibrationRates, TheSlowestArmThatMayBeCalibratedHasFramesForItsMeans) {
  ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
  for (const double rate_hz : {4.1, 5.0, 5.9, 20.0, 30.0}) {
    arm.frame_rate_hz = rate_hz;
    EXPECT_NO_THROW(require_rate_to_be_seen(arm)) << rate_hz;
    EXPECT_EQ(before_mean_frames(arm.frame_period_s()), std::size_t(arm.frames_in(0.5))) << rate_hz;
    EXPECT_GE(before_mean_frames(arm.frame_period_s()), 3U) << rate_hz;
  }
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

/// Frame B in the tracker's 3D frame, in metres; of a tracker in 2D, its x and y are the plane.
Eigen::Isometry3d base_in_3d(const TrackerCalibration& tracker) {
  const TrackerPlane plane = tracker.plane.value_or(TrackerPlane{});
  const double side = tracker.mirrored ? -1.0 : 1.0;
  const Eigen::Vector3d y_axis = side * plane.y_axis;
  const double c = std::cos(tracker.base.theta_rad);
  const double s = std::sin(tracker.base.theta_rad);
  Eigen::Isometry3d base;
  base.linear() << c * plane.x_axis + s * y_axis, -s * plane.x_axis + c * y_axis,
      side * plane.normal();
  base.translation() = tracker.metres_per_unit * plane.origin + tracker.base.x_m * plane.x_axis +
                       tracker.base.y_m * y_axis;
  return base;
}

/// The found base in the true one's frame; its height is that of a marker body.
Eigen::Isometry3d base_error(const WireCalibration& found, const Misassembly& wrong) {
  return base_in_3d(*wrong.truth.tracker).inverse() * base_in_3d(*found.tracker);
}

double position_error_m(const WireCalibration& found, const Misassembly& wrong) {
  return base_error(found, wrong).translation().head<2>().norm();
}

double heading_error_rad(const WireCalibration& found, const Misassembly& wrong) {
  const Eigen::Isometry3d error = base_error(found, wrong);
  return std::abs(std::atan2(error.linear()(1, 0), error.linear()(0, 0)));
}

/// Between the planes' normals.
double tilt_error_rad(const WireCalibration& found, const Misassembly& wrong) {
  return std::acos(std::min(1.0, base_error(found, wrong).linear()(2, 2)));
}

ArmState through_both(const WireCalibration& found, const Misassembly& wrong,
                      const ArmState& state) {
  ArmState on_wire = wrong.truth.to_wire(state);
  if (!wrong.truth.tracker->plane) {
    return found.from_wire(on_wire);
  }
  const BodyPoses bodies =
      bodies_in_space(*wrong.truth.tracker->plane, *on_wire.backbone, wrong.body_heights);
  on_wire.backbone.reset();
  return found.from_wire(on_wire, bodies);
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
    const ArmState back = through_both(found, wrong, state);
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
  EXPECT_EQ(found.tracker->plane.has_value(), wrong.truth.tracker->plane.has_value());
  EXPECT_LT(tilt_error_rad(found, wrong), kTiltRad);
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
  double tilt_rad = 0.0;
  double delay_s = 0.0;

  void note(const WireCalibration& found, const Misassembly& wrong) {
    position_m = std::max(position_m, position_error_m(found, wrong));
    heading_rad = std::max(heading_rad, heading_error_rad(found, wrong));
    tilt_rad = std::max(tilt_rad, tilt_error_rad(found, wrong));
    delay_s =
        std::max(delay_s, std::abs(found.clocks.shape_delay->value_s - wrong.tracker_latency_s));
  }
  void print(const char* what) const {
    std::printf("%s: at worst %.2f mm, %.4f rad, plane %.5f rad, %.1f ms off\n", what,
                1e3 * position_m, heading_rad, tilt_rad, 1e3 * delay_s);
  }
};

using DrawMisassembly = Misassembly (*)(const ArmDescription&, std::uint64_t);

void expect_recovered(DrawMisassembly draw) {
  const CalibrationTolerance tolerance;
  Worst with_marker;
  Worst without;
  int refused = 0;
  int refused_with_marker = 0;
  for (int k = 0; k < case_count(); ++k) {
    SCOPED_TRACE(k);
    const auto seed = static_cast<std::uint64_t>(k);
    const ArmDescription arm = arm_of(seed);
    const Misassembly wrong = draw(arm, seed);
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

// 200 of these: frames, permutations, signs, units and delays come back, or are refused.
TEST(CalibrationEstimate, RecoversWhatWasPutTogetherWrongly) {
  expect_recovered(draw_misassembly);
}

// The same of trackers that see bodies in 3D, in any frame: the plane comes back too.
TEST(CalibrationEstimate, RecoversWhatATrackerIn3dSeesWrongly) {
  expect_recovered(draw_misassembly_in_3d);
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

TEST(CalibrationEstimate, RefusesTheSameOfBodiesIn3d) {
  const ArmDescription arm = arm_of(3);
  const Misassembly wrong = draw_misassembly_in_3d(arm, 3);
  const auto refusal = [&](Flaw flaw) { return calibrated(arm, wrong, flaw, 3).known.refusal; };
  EXPECT_THAT(refusal(Flaw::crossed_hoses), HasSubstr("hoses are crossed between segments"));
  EXPECT_THAT(refusal(Flaw::dead_channel), HasSubstr("channel 1 at 10 kPa moved nothing"));
  EXPECT_THAT(refusal(Flaw::bodies_reversed), HasSubstr("come in another order"));
  EXPECT_THAT(refusal(Flaw::bodies_swapped), HasSubstr("come in another order"));
  EXPECT_THAT(refusal(Flaw::other_arm), HasSubstr("no unit (m, cm, mm, in) fits"));
}

}  // namespace
}  // namespace limber
