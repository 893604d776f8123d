#include "seen_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kBeforeMeanS = 0.5;
constexpr double kPoseMeanS = 2.0;  // at the end of a hold
constexpr int kMinSeenFrames = 3;

/// Takes leaps of a whole turn out of a column; what is not seen is passed over.
template <class Column>
void unwrap_over_time(Column column) {
  constexpr double kWholeTurn = 2.0 * std::numbers::pi;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (double& value : column) {
    if (std::isfinite(value)) {
      if (std::isfinite(before)) {
        value -= kWholeTurn * std::round((value - before) / kWholeTurn);
      }
      before = value;
    }
  }
}

double squared(double value) {
  return value * value;
}

}  // namespace

void require_rate_to_be_seen(const ArmDescription& arm) {
  refuse_if(arm.frames_in(kBeforeMeanS) < kMinSeenFrames,
            "arm '{}' runs at {:g} Hz; a calibration takes means over {:g} s of at least {} frames",
            arm.name, arm.frame_rate_hz, kBeforeMeanS, kMinSeenFrames);
}

std::size_t before_mean_frames(double frame_period_s) {
  constexpr double kRounding = 1e-9;  // as ArmDescription::frames_in
  return std::size_t(std::ceil(kBeforeMeanS / frame_period_s - kRounding));
}

SeenPoses seen_poses(const CalibrationLog& log) {
  const auto first = std::find_if(log.frames.begin(), log.frames.end(),
                                  [](const auto& f) { return f.state.backbone.has_value(); });
  if (first == log.frames.end()) {
    throw CalibrationRefused(
        "no state has a backbone or bodies: nothing tracks the "
        "arm, so which channel moves what can't be seen");
  }
  const auto frames = Eigen::Index(log.frames.size());
  const double unseen = std::numeric_limits<double>::quiet_NaN();
  SeenPoses poses;
  poses.x.setConstant(frames, first->state.backbone->rows(), unseen);
  poses.y = poses.x;
  poses.theta = poses.x;
  for (Eigen::Index k = 0; k < frames; ++k) {
    const auto& backbone = log.frames[k].state.backbone;
    if (backbone) {
      poses.x.row(k) = backbone->col(0).cast<double>().transpose();
      poses.y.row(k) = backbone->col(1).cast<double>().transpose();
      poses.theta.row(k) = backbone->col(2).cast<double>().transpose();
    }
  }
  return poses;
}

SeenPoses in_metres(const SeenPoses& raw, const TrackerCalibration& tracker) {
  SeenPoses poses;
  const double side = tracker.mirrored ? -1.0 : 1.0;
  poses.x = tracker.metres_per_unit * raw.x;
  poses.y = side * tracker.metres_per_unit * raw.y;
  poses.theta = side * tracker.radians_per_unit * raw.theta;
  for (Eigen::Index body = 0; body < poses.bodies(); ++body) {
    unwrap_over_time(poses.theta.col(body));
  }
  return poses;
}

void require_seen(int seen, std::size_t frames, const char* when) {
  if (seen < kMinSeenFrames) {
    throw CalibrationRefused(
        fmt::format("the tracker saw the arm in {} of {} frames {}; expected at least {}", seen,
                    frames, when, kMinSeenFrames));
  }
}

MeanPose mean_pose(const SeenPoses& poses, std::size_t first, std::size_t end, const char* when) {
  MeanPose mean;
  mean.pose.setZero(poses.bodies(), kPoseSize);
  for (std::size_t frame = first; frame < end; ++frame) {
    if (poses.seen(frame)) {
      const auto k = Eigen::Index(frame);
      mean.pose.col(0) += poses.x.row(k).transpose();
      mean.pose.col(1) += poses.y.row(k).transpose();
      mean.pose.col(2) += poses.theta.row(k).transpose();
      ++mean.count;
    }
  }
  require_seen(mean.count, end - first, when);
  mean.pose /= mean.count;
  return mean;
}

PoseNoise pose_noise(const SeenPoses& poses, std::size_t first, std::size_t end) {
  double positions = 0.0;
  double angles = 0.0;
  int count = 0;
  for (std::size_t frame = first + 1; frame < end; ++frame) {
    if (!poses.seen(frame) || !poses.seen(frame - 1)) {
      continue;
    }
    const auto k = Eigen::Index(frame);
    for (Eigen::Index body = 0; body < poses.bodies(); ++body) {
      positions += squared(poses.x(k, body) - poses.x(k - 1, body)) +
                   squared(poses.y(k, body) - poses.y(k - 1, body));
      angles += squared(poses.theta(k, body) - poses.theta(k - 1, body));
      ++count;
    }
  }
  // Two neighbours differ by √2 of what one is off by.
  const double pairs = std::max(count, 1);
  return {std::sqrt(positions / (4.0 * pairs)), std::sqrt(angles / (2.0 * pairs))};
}

PulseWindows pulse_windows(const CalibrationPulse& pulse, double frame_period_s) {
  const std::size_t before = before_mean_frames(frame_period_s);
  const auto frames = std::size_t(std::lround(kPoseMeanS / frame_period_s));
  return {{pulse.first, pulse.first + before, "before a pulse"},
          {pulse.hold_end - frames, pulse.hold_end, "of a held pulse"},
          {pulse.end - frames, pulse.end, "after a pulse"}};
}

std::vector<PulsePoses> pulse_poses(const SeenPoses& poses, const CalibrationLog& log,
                                    double frame_period_s) {
  return each_pulse<MeanPose>(log, frame_period_s, [&](const FrameWindow& window) {
    return mean_pose(poses, window.first, window.end, window.when);
  });
}

}  // namespace limber
