#include "limber/driver/calibration_estimate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base_frame.hpp"
#include "channel_map.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/damped_solve.hpp"
#include "limber/common/statistics.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "motion_plane.hpp"
#include "seen_poses.hpp"
#include "tracker_units.hpp"

namespace limber {

namespace {

constexpr double kMaxDelayS = 0.5;
constexpr double kMaxAheadS = 0.1;  // of a tracker whose clock runs ahead
constexpr double kDelayGridS = 0.0005;
constexpr double kRampLow = 0.1;  // of the pressure's range: ends are held, not ramped
constexpr double kRampHigh = 0.9;
constexpr double kHeldShare = 0.004;  // of the range, from frame to frame: less is a hold
constexpr Eigen::Index kKnots = 12;   // of a branch
constexpr double kMaxHalfIntervalS = 0.03;
constexpr double kDelayModelErrorS = 0.002;  // of what pressures do between samples
constexpr double kTwoSigmaSquared = 4.0;

struct Signal {
  std::vector<double> time_s;
  std::vector<double> value;
};

/// Shape over pressure, each way a branch of its own, straight between knots.
struct Branch {
  Eigen::Matrix<double, kKnots, kKnots> normal = Eigen::Matrix<double, kKnots, kKnots>::Zero();
  Eigen::Matrix<double, kKnots, 1> right = Eigen::Matrix<double, kKnots, 1>::Zero();
  double square = 0.0;

  /// @param level  of the range, from kRampLow to kRampHigh
  void add(double level, double value) {
    const double at = (level - kRampLow) / (kRampHigh - kRampLow) * double(kKnots - 1);
    const auto knot = std::clamp<Eigen::Index>(Eigen::Index(at), 0, kKnots - 2);
    const double share = at - double(knot);
    const Eigen::Vector2d hat(1.0 - share, share);
    normal.block<2, 2>(knot, knot) += hat * hat.transpose();
    right.segment<2>(knot) += value * hat;
    square += value * value;
  }

  /// What is left of the squares once the knots are where they fit best.
  double misfit() const {
    constexpr double kRidge = 1e-9;  // for knots without a sample
    return std::max(0.0, square - right.dot(damped_solve(normal, right, kRidge)));
  }
};

struct LoopMisfit {
  double squares = std::numeric_limits<double>::infinity();
  int samples = 0;
};

/// Share of the way to its set point that a reading goes within a frame. Set points jump from frame
/// to frame, so between two samples a pressure bends as a valve of first order bends it.
double share_per_frame(const CalibrationLog& log, int channel, double sign, double zero_kpa,
                       int sensor) {
  constexpr double kMinSpreadShare = 0.05;
  constexpr double kMaxSpreadShare = 0.95;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t k = log.timing.first + 1; k < log.timing.end; ++k) {
    const double before = log.frames[k - 1].state.pressure_kpa[sensor] - zero_kpa;
    const double step = log.frames[k].state.pressure_kpa[sensor] - zero_kpa - before;
    const double left = sign * log.frames[k - 1].setpoint_kpa[channel] - before;
    product += left * step;
    square += left * left;
  }
  return square > 0.0 ? std::clamp(product / square, kMinSpreadShare, kMaxSpreadShare)
                      : kMinSpreadShare;
}

/// How far slow and fast loops are from one curve each way, were shapes `delay_s` late.
/// @param valve_share  of `share_per_frame`
LoopMisfit loop_misfit(const Signal& pressure, const Signal& shape, double valve_share,
                       double delay_s) {
  const auto [low, high] = std::minmax_element(pressure.value.begin(), pressure.value.end());
  const double range = *high - *low;
  std::array<Branch, 2> branches;
  LoopMisfit result;
  std::size_t k = 1;
  for (std::size_t i = 0; i < shape.time_s.size(); ++i) {
    const double t = shape.time_s[i] - delay_s;
    if (t < pressure.time_s.front() || t > pressure.time_s.back()) {
      continue;
    }
    while (k + 1 < pressure.time_s.size() && pressure.time_s[k] < t) {
      ++k;
    }
    const double before = (pressure.value[k - 1] - *low) / range;
    const double after = (pressure.value[k] - *low) / range;
    const double in_frame =
        (t - pressure.time_s[k - 1]) / (pressure.time_s[k] - pressure.time_s[k - 1]);
    const double level =
        before + (after - before) * (1.0 - std::pow(1.0 - valve_share, in_frame)) / valve_share;
    if (std::abs(after - before) > kHeldShare && level >= kRampLow && level <= kRampHigh) {
      branches[after > before ? 0 : 1].add(level, shape.value[i]);
      ++result.samples;
    }
  }
  result.squares = branches[0].misfit() + branches[1].misfit();
  return result;
}

struct DelayFit {
  double delay_s = 0.0;
  double half_interval_s = 0.0;
};

DelayFit fit_delay(const Signal& pressure, const Signal& shape, double valve_share) {
  std::vector<double> delays;
  std::vector<double> squares;
  int samples = 0;
  for (double delay_s = -kMaxAheadS; delay_s <= kMaxDelayS; delay_s += kDelayGridS) {
    const LoopMisfit misfit = loop_misfit(pressure, shape, valve_share, delay_s);
    delays.push_back(delay_s);
    squares.push_back(misfit.samples > 0 ? misfit.squares / misfit.samples
                                         : std::numeric_limits<double>::infinity());
    samples = std::max(samples, misfit.samples);
  }
  const auto best = std::size_t(std::min_element(squares.begin(), squares.end()) - squares.begin());
  const double freedom = std::max(1.0, samples - 2.0 * kKnots);
  const double limit = squares[best] * (1.0 + kTwoSigmaSquared / freedom);
  std::size_t first = best;
  std::size_t last = best;
  while (first > 0 && squares[first - 1] <= limit) {
    --first;
  }
  while (last + 1 < squares.size() && squares[last + 1] <= limit) {
    ++last;
  }
  const double half_s = 0.5 * (delays[last] - delays[first]) + kDelayModelErrorS;
  if (half_s > kMaxHalfIntervalS || first == 0 || last + 1 == squares.size()) {
    throw CalibrationRefused(fmt::format(
        "by how much shapes are older than pressures can't be told: from {:.0f} to {:.0f} ms. Is "
        "the shape tracked in every frame, and does `t` say when a sample was taken?",
        1e3 * delays[first], 1e3 * delays[last]));
  }
  return {delays[best], half_s};
}

/// What each body turned by, from the first of so many frames of the timing step to its peak.
Eigen::VectorXd turned_rad(const CalibrationLog& log, const SeenPoses& poses, std::size_t frames) {
  const auto mean = [&](std::size_t first) {
    return mean_pose(poses, first, first + frames, "of the timing step");
  };
  return (mean(log.timing.peak).pose - mean(log.timing.first).pose).col(2);
}

/// θ of all bodies in one number: along what they turned by from the first frames to the peak.
Signal turn_signal(const CalibrationLog& log, const SeenPoses& poses, double frame_period_s,
                   const std::vector<double>& time_s) {
  const CalibrationTiming& timing = log.timing;
  const Eigen::VectorXd turned = turned_rad(log, poses, before_mean_frames(frame_period_s));
  Signal signal;
  for (std::size_t k = timing.first; k < timing.end; ++k) {
    if (poses.seen(k)) {
      signal.time_s.push_back(time_s[k]);
      signal.value.push_back(poses.theta.row(Eigen::Index(k)).dot(turned) / turned.squaredNorm());
    }
  }
  return signal;
}

/// Middle of what the driver's clock is ahead of the tracker's when a state is sent; none where a
/// state has no tracker's time.
std::optional<double> apart_s(const CalibrationLog& log) {
  std::vector<double> apart;
  for (std::size_t k = log.timing.first; k < log.timing.end; ++k) {
    const CalibrationFrame& frame = log.frames[k];
    if (frame.state.backbone && !frame.state.tracker_s) {
      return std::nullopt;
    }
    if (frame.state.tracker_s) {
      apart.push_back(frame.state.time_s - *frame.state.tracker_s);
    }
  }
  return apart.empty() ? std::nullopt : std::optional(median(std::move(apart)));
}

/// By how much shapes are older than the pressures beside them. Friction makes a shape depend on
/// which way the pressure goes, but hardly on how fast: so fast ramps have to draw the same loop as
/// slow ones, once shapes are moved to the time that they were true at. The arm's own lag is in it.
///
/// @param valve, sensor  of the segment that ramps
/// @param zero_kpa       of that sensor
/// Fills `shape_delay` and, where the tracker has a clock of its own, `tracker`.
/// @throws CalibrationRefused where the loops are drawn too badly to tell.
void fit_shape_delay(const ArmDescription& arm, const CalibrationLog& log, const SeenPoses& poses,
                     const WireChannel& valve, const WireChannel& sensor, double zero_kpa,
                     ClockCalibration& clocks) {
  const std::optional<double> apart = apart_s(log);
  Signal pressure;
  std::vector<double> shape_time_s;
  // The first slow loop leads from rest into the loop that the others draw.
  const std::size_t loop_first = log.timing.first + (log.timing.fast_first - log.timing.first) / 2;
  for (std::size_t k = 0; k < log.frames.size(); ++k) {
    const CalibrationFrame& frame = log.frames[k];
    shape_time_s.push_back(apart && frame.state.tracker_s ? *frame.state.tracker_s + *apart
                                                          : frame.state.time_s);
    if (k >= loop_first && k < log.timing.end) {
      pressure.time_s.push_back(frame.state.time_s);
      pressure.value.push_back(frame.state.pressure_kpa[sensor.channel]);
    }
  }
  const double share =
      share_per_frame(log, valve.channel, valve.sign * sensor.sign, zero_kpa, sensor.channel);
  const DelayFit fit =
      fit_delay(pressure, turn_signal(log, poses, arm.frame_period_s(), shape_time_s), share);
  clocks.shape_delay = TimeInterval{fit.delay_s, fit.delay_s - fit.half_interval_s,
                                    fit.delay_s + fit.half_interval_s};
  if (apart) {
    // How much of the delay is the arm's own lag is not known: all of it, or nothing.
    clocks.tracker =
        TimeInterval{*apart - fit.delay_s, *apart - fit.delay_s - fit.half_interval_s, *apart};
  }
}

/// limber's clock against the driver's: a sample is taken before its answer arrives, and not before
/// the request, or a frame earlier where the driver answers with what it has. Each exchange bounds
/// the offset so; a drift is taken out first. Fills `driver` and `driver_drift`.
///
/// @param frame_period_s  what a sample may be older than the request by
void fit_driver_clock(const CalibrationLog& log, double frame_period_s, ClockCalibration& clocks) {
  if (!log.real_time || log.frames.empty()) {
    return;
  }
  double mean_t = 0.0;
  double mean_offset = 0.0;
  const auto count = double(log.frames.size());
  const auto middle = [](const CalibrationFrame& f) {
    return 0.5 * (f.sent_s + f.received_s) - f.state.time_s;
  };
  for (const CalibrationFrame& frame : log.frames) {
    mean_t += frame.state.time_s / count;
    mean_offset += middle(frame) / count;
  }
  double product = 0.0;
  double square = 0.0;
  for (const CalibrationFrame& frame : log.frames) {
    const double t = frame.state.time_s - mean_t;
    product += t * (middle(frame) - mean_offset);
    square += t * t;
  }
  clocks.driver_drift = square > 0.0 ? product / square : 0.0;
  double low_s = -std::numeric_limits<double>::infinity();
  double high_s = std::numeric_limits<double>::infinity();
  for (const CalibrationFrame& frame : log.frames) {
    const double drifted_s = clocks.driver_drift * (frame.state.time_s - mean_t);
    low_s = std::max(low_s, frame.sent_s - frame.state.time_s - drifted_s);
    high_s = std::min(high_s, frame.received_s - frame.state.time_s - drifted_s);
  }
  if (low_s > high_s) {  // samples are older than requests: how much is not known
    low_s = high_s - frame_period_s;
  }
  clocks.driver = TimeInterval{0.5 * (low_s + high_s), low_s, high_s};
}

/// Whether the tracker is mirrored, from which way it saw the arm bend and which way it bent.
bool is_mirrored(const CalibrationLog& log, const SeenPoses& poses, const OperatorAnswer& answer,
                 double frame_period_s) {
  if (answer.mirrored) {
    return *answer.mirrored;
  }
  const Eigen::VectorXd turned = turned_rad(log, poses, before_mean_frames(frame_period_s));
  Eigen::Index most = 0;
  turned.cwiseAbs().maxCoeff(&most);
  return (turned[most] > 0.0) == *answer.bends_right;
}

WireCalibration estimate(const ArmDescription& arm, const CalibrationLog& log,
                         const OperatorAnswer& answer, const CalibrationTolerance& tolerance) {
  WireCalibration result = identity_calibration(arm);
  take_rest_pressures(log, result);
  const SeenPoses raw = seen_poses(log);
  TrackerCalibration tracker = tracker_units(arm, raw, log);
  tracker.mirrored = is_mirrored(log, in_metres(raw, tracker), answer, arm.frame_period_s());
  const SeenPoses poses = in_metres(raw, tracker);
  result.valves = valve_channels(arm, log, poses);
  result.sensors = sensor_channels(arm, log, result.valves, result.zero_kpa);
  fit_base_frame(arm, log, poses, result.valves, answer.base_marker_m, tracker);
  if (tracker.position_interval_m > tolerance.position_m ||
      tracker.heading_interval_rad > tolerance.heading_rad) {
    throw CalibrationRefused(
        fmt::format("the base's frame is known to ± {:.2f} mm and ± {:.5f} rad only; asked for "
                    "are {:.2f} mm and {:.5f} rad. Say where the base's marker body sits as "
                    "built (--base-marker), or ask for less (--tolerance-m, --tolerance-rad). "
                    "Left and right exchanged (--handedness) do this too",
                    1e3 * tracker.position_interval_m, tracker.heading_interval_rad,
                    1e3 * tolerance.position_m, tolerance.heading_rad));
  }
  result.tracker = tracker;
  fit_driver_clock(log, arm.frame_period_s(), result.clocks);
  const auto segment = std::size_t(segment_on(result.valves, log.timing.channel));
  const WireChannel& sensor = result.sensors[segment];
  fit_shape_delay(arm, log, poses, result.valves[segment], sensor, result.zero_kpa[sensor.channel],
                  result.clocks);
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
