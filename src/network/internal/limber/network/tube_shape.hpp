#pragma once

#include <vector>

#include "limber/network/prediction_error.hpp"

namespace limber {

// What no scale of a tube is below: the certificate's deviation is no smaller.
inline constexpr double kMinScaleM = 1e-4;
inline constexpr double kMinScaleRad = 1e-3;

/// How far an arm was from its prediction over a motion (docs/tube.md, (1)).
struct MotionErrors {
  /// Largest over the motion's frames, one per plate, each over the share of its room that the
  /// plate has there.
  std::vector<double> plate_m;
  double end_m = 0.0;  ///< of the tip at the end, after the hold
  double end_heading_rad = 0.0;
};

/// (2) of docs/tube.md, with limber's own numbers.
RoomGrowth usual_growth(double arm_length_m);

/// Shape of a tube, without levels (docs/tube.md, (3)): what most of the motions stay below.
/// @param motions  at least one, all of one arm, with that growth
Tube tube_shape(const std::vector<MotionErrors>& motions, const RoomGrowth& growth);

/// The largest of a motion's errors over their scales, of the plates alone. @pre sizes agree
double score_of(const std::vector<double>& plate_m, const std::vector<double>& plate_scale_m);

}  // namespace limber
