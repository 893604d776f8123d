#pragma once
// For those who train and evaluate models.

#include <vector>

#include "limber/data/recording.hpp"

namespace limber {

/// Over frames: mean, standard deviation (of the population) and 95th percentile; and the largest
/// mean over the frames of one commanded motion. NaN if there is no frame.
struct ErrorStatistics {
  double mean = 0.0;
  double std = 0.0;
  double p95 = 0.0;
  double worst_motion = 0.0;
};

/// Errors of the end effector, and of all plates but the base, mean over them.
struct TipErrors {
  ErrorStatistics position_cm;
  ErrorStatistics orientation_rad;
  ErrorStatistics plates_cm;
};

/// Errors of predicted tips, one per frame; NaN if the arm was not tracked or nothing was
/// predicted.
struct TipErrorSeries {
  std::vector<double> position_cm;
  std::vector<double> orientation_rad;
  std::vector<int> motion;   ///< which commanded motion the frame belongs to, falling nowhere
  std::vector<bool> moving;  ///< the recorded tip moved by at least kMovingTip_m since the frame
                             ///< before
  std::vector<double> plates_cm;  ///< mean over all plates but the base
};

/// 4 cm/s at 20 Hz: an arm at rest is slower, a moving arm is faster.
inline constexpr double kMovingTip_m = 0.002;

/// `predicted` (T×3m) against what was recorded; the first frame is given, and left out.
TipErrorSeries tip_errors(const FrameMatrix& predicted, const Episode& episode);

/// Appends the frames of another episode; the numbering of motions continues.
void append(TipErrorSeries& series, const TipErrorSeries& more);

/// The frames in which the arm moved.
TipErrorSeries moving_frames(const TipErrorSeries& series);

/// Statistics over the frames that are not NaN.
TipErrors summarise(const TipErrorSeries& series);

}  // namespace limber
