#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "log_tracks.hpp"

namespace limber {

/// By how much each segment turns, over a log's own times. The times are borrowed from the track.
struct Turns {
  const std::vector<double>& time_s;
  Eigen::MatrixXd values;  ///< T×n [rad], NaN where unknown
  bool held = false;       ///< set points: in force until the next row

  /// On the straight line between the rows around `time_s`, or held; NaN outside of them, or beside
  /// a NaN.
  double at(double time_s, Eigen::Index column) const;
};

/// Seen: heading of each segment's last plate less that of its first.
Turns turns_of(const BackboneTrack& motion, const ArmDescription& arm);

/// Told: what the no-load model makes of the commands; where that is straight, the commands.
Turns turns_of(const CommandTrack& commands, const ArmDescription& arm);

}  // namespace limber
