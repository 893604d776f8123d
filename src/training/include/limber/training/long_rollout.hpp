#pragma once
// For those who train and evaluate models.

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"

namespace limber {

/// How far a model drifts if it is never corrected.
struct LongRollout {
  int frames = 0;                ///< rolled out
  double max_distance_m = 0.0;   ///< of a plate from the base; of finite frames
  double max_heading_rad = 0.0;  ///< of a plate, in magnitude
  /// Of the frames, in which (20) held a gap's length or turn at its bound; 0 of a model without.
  double held_share = 0.0;
  /// By the model alone: all finite, no plate farther than twice the arm's length, and held_share
  /// at most kMaxHeldShare.
  bool bounded = false;

  /// A sound model hardly ever touches its bounds. One that leans on them would run away without.
  static constexpr double kMaxHeldShare = 0.1;
};

/// Frames of the check: a quarter of an hour at 20 Hz.
inline constexpr int kLongRolloutFrames = 20'000;

/// Rolls `model` out over the measured pressures of the longest episode, forward and back again,
/// from the first tracked backbone; of several episodes each of the four longest, a part of
/// `frames` each. Errors that amplify themselves show within some thousand frames; a model that
/// stays within twice the arm's length for a quarter of an hour will stay there. Zero frames, and
/// bounded, if no frame follows a tracked one.
LongRollout roll_out_long(const ForwardModel& model, const std::vector<Episode>& episodes,
                          int frames = kLongRolloutFrames);

}  // namespace limber
