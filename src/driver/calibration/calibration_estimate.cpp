#include "limber/driver/calibration_estimate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "base_frame.hpp"
#include "channel_map.hpp"
#include "clock_fit.hpp"
#include "motion_plane.hpp"
#include "seen_poses.hpp"
#include "shape_delay.hpp"
#include "tracker_units.hpp"

namespace limber {

namespace {

/// Whether the tracker is mirrored, from which way it saw the arm bend and which way it bent.
bool is_mirrored(const CalibrationLog& log, const SeenPoses& poses, const OperatorAnswer& answer,
                 double frame_period_s) {
  if (answer.mirrored) {
    return *answer.mirrored;
  }
  const auto frames = static_cast<std::size_t>(std::max(1.0, 0.5 / frame_period_s));
  const std::size_t peak = log.timing.peak;
  const Eigen::VectorXd turned =
      (mean_pose(poses, peak, peak + frames, "of the timing step").pose -
       mean_pose(poses, log.timing.first, log.timing.first + frames, "of the timing step").pose)
          .col(2);
  Eigen::Index most = 0;
  turned.cwiseAbs().maxCoeff(&most);
  return (turned[most] > 0.0) == *answer.bends_right;
}

WireCalibration estimate(const ArmDescription& arm, const CalibrationLog& log,
                         const OperatorAnswer& answer, const CalibrationTolerance& tolerance) {
  WireCalibration result = identity_calibration(arm);
  const RestPressures rest = rest_pressures(log);
  result.zero_kpa = rest.zero_kpa;
  result.noise_kpa = rest.noise_kpa;
  const SeenPoses raw = seen_poses(log);
  const TrackerUnits units = tracker_units(arm, raw, log);
  TrackerCalibration tracker;
  tracker.metres_per_unit = units.metres_per_unit;
  tracker.radians_per_unit = units.radians_per_unit;
  tracker.mirrored =
      is_mirrored(log, in_metres(raw, units.metres_per_unit, units.radians_per_unit, false), answer,
                  arm.frame_period_s());
  const SeenPoses poses =
      in_metres(raw, units.metres_per_unit, units.radians_per_unit, tracker.mirrored);
  result.valves = valve_channels(arm, log, poses);
  result.sensors = sensor_channels(arm, log, result.valves, rest);
  const BaseFrame frame = base_frame(arm, log, poses, result.valves, answer.base_marker_m);
  if (frame.position_interval_m > tolerance.position_m ||
      frame.heading_interval_rad > tolerance.heading_rad) {
    throw CalibrationRefused(
        fmt::format("the base's frame is known to ± {:.2f} mm and ± {:.5f} rad only; asked for "
                    "are {:.2f} mm and {:.5f} rad. Say where the base's marker body sits as "
                    "built (--base-marker), or ask for less (--tolerance-m, --tolerance-rad)",
                    1e3 * frame.position_interval_m, frame.heading_interval_rad,
                    1e3 * tolerance.position_m, tolerance.heading_rad));
  }
  tracker.base = frame.base;
  tracker.marker_offsets = frame.marker_offsets;
  tracker.position_interval_m = frame.position_interval_m;
  tracker.heading_interval_rad = frame.heading_interval_rad;
  result.tracker = tracker;
  fit_driver_clock(log, arm.frame_period_s(), result.clocks);
  const auto segment = static_cast<std::size_t>(
      std::find_if(result.valves.begin(), result.valves.end(),
                   [&](const WireChannel& one) { return one.channel == log.timing.channel; }) -
      result.valves.begin());
  const WireChannel& sensor = result.sensors[segment];
  fit_shape_delay(arm, log, poses, result.valves[segment], sensor,
                  result.zero_kpa[static_cast<std::size_t>(sensor.channel)], result.clocks);
  return result;
}

/// `estimate` of a tracker that sees in 3D, in the plane of the motion.
WireCalibration estimate_in_3d(const ArmDescription& arm, const CalibrationLog& log,
                               const OperatorAnswer& answer,
                               const CalibrationTolerance& tolerance) {
  const TrackerPlane plane = motion_plane(arm, log);
  WireCalibration result = estimate(arm, in_plane(log, plane), answer, tolerance);
  if (std::abs(result.tracker->radians_per_unit) != 1.0) {
    throw CalibrationRefused(
        "quaternions turn much farther than positions do. Are they those of the same bodies?");
  }
  result.tracker->plane = plane;
  return result;
}

}  // namespace

CalibrationEstimate estimate_calibration(const ArmDescription& arm, const CalibrationLog& log,
                                         const OperatorAnswer& answer,
                                         const CalibrationTolerance& tolerance) {
  assert(answer.mirrored || answer.bends_right);
  CalibrationEstimate result;
  try {
    result.calibration = has_bodies(log) ? estimate_in_3d(arm, log, answer, tolerance)
                                         : estimate(arm, log, answer, tolerance);
  } catch (const CalibrationRefused& refused) {
    result.refusal = refused.what();
  }
  return result;
}

}  // namespace limber
