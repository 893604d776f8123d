#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/motion_model.hpp"

namespace limber {

/// How far recorded backbones are from those that the model predicts from set points alone. Per
/// run: over its tracked frames and all plates; then the mean over runs.
struct OpenLoopError {
  int runs = 0;
  double mean_m = 0.0;     ///< of the distance over plates and frames
  double largest_m = 0.0;  ///< of the largest distance

  bool operator==(const OpenLoopError&) const = default;
};

/// Executed plans: each episode is one run, from where the arm was measured to lie.
OpenLoopError error_on_plans(const MotionModel& model, const std::vector<Episode>& plans);

/// Random motions, each from where the arm had come to rest after the one before. Motions that
/// begin in a frame that was not tracked don't count.
OpenLoopError error_on_motions(const MotionModel& model, const std::vector<Episode>& motions);

}  // namespace limber
