#pragma once

#include <stdexcept>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"

namespace limber {

/// What does not fit, with what would. Ends an estimate.
class CalibrationRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Marker bodies over all frames of a log, in the tracker's frame: frames ×
/// bodies. Frames without a shape are NaN.
struct SeenPoses {
  Eigen::MatrixXd x, y;
  Eigen::MatrixXd theta;

  Eigen::Index bodies() const { return x.cols(); }
  bool seen(std::size_t frame) const { return std::isfinite(x(Eigen::Index(frame), 0)); }
};

/// One mean pose of every body: m×3, and how many frames it is of.
struct MeanPose {
  Eigen::MatrixX3d pose;
  int count = 0;
};

/// @throws InputError where the arm's frames are too long for the means that are taken here.
void require_rate_to_be_seen(const ArmDescription& arm);

/// In the mean before something moves: as many frames as `require_rate_to_be_seen` counts.
std::size_t before_mean_frames(double frame_period_s);

/// As the wire has them. @throws CalibrationRefused where nothing tracks the arm.
SeenPoses seen_poses(const CalibrationLog& log);

/// θ in rad, unwrapped over time; lengths in metres; y and θ turned over where mirrored.
SeenPoses in_metres(const SeenPoses& raw, const TrackerCalibration& tracker);

/// @throws CalibrationRefused where a mean would be of fewer than three frames.
void require_seen(int seen, std::size_t frames, const char* when);

/// Over frames `first` to `end` − 1. @throws CalibrationRefused where fewer than three are seen.
MeanPose mean_pose(const SeenPoses& poses, std::size_t first, std::size_t end, const char* when);

/// Standard deviations of one frame, from what changes between neighbouring frames at rest.
struct PoseNoise {
  double position_m = 0.0;
  double theta_rad = 0.0;
};
PoseNoise pose_noise(const SeenPoses& poses, std::size_t first, std::size_t end);

/// Frames `first` to `end` − 1 of a pulse; `when` is for messages.
struct FrameWindow {
  std::size_t first = 0;
  std::size_t end = 0;
  const char* when = "";
};
/// Before a pulse, at the end of its hold, and at its end.
template <class T>
struct Pulse {
  T before, held, after;
};
using PulseWindows = Pulse<FrameWindow>;
PulseWindows pulse_windows(const CalibrationPulse& pulse, double frame_period_s);

/// What `mean` makes of every pulse's windows.
template <class T, class Mean>
std::vector<Pulse<T>> each_pulse(const CalibrationLog& log, double frame_period_s,
                                 const Mean& mean) {
  std::vector<Pulse<T>> result;
  for (const CalibrationPulse& pulse : log.pulses) {
    const PulseWindows windows = pulse_windows(pulse, frame_period_s);
    result.push_back({mean(windows.before), mean(windows.held), mean(windows.after)});
  }
  return result;
}

using PulsePoses = Pulse<MeanPose>;
std::vector<PulsePoses> pulse_poses(const SeenPoses& poses, const CalibrationLog& log,
                                    double frame_period_s);

}  // namespace limber
