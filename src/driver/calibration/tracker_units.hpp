#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "seen_poses.hpp"

namespace limber {

/// Units of a tracker, and the sense of its θ.
struct TrackerUnits {
  double metres_per_unit = 1.0;   ///< m, cm, mm or inches
  double radians_per_unit = 1.0;  ///< rad or degrees; < 0 where θ goes against x and y
};

/// From the arm's length at rest, and from how headings turn while positions do. `raw` is as the
/// wire has it. @throws CalibrationRefused where the bodies are not the arm's plates in their
/// order, with the order that would fit, or no unit fits.
TrackerUnits tracker_units(const ArmDescription& arm, const SeenPoses& raw,
                           const CalibrationLog& log);

}  // namespace limber
