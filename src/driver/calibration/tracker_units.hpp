#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "seen_poses.hpp"

namespace limber {

/// Units of a tracker (m, cm, mm or inches; rad or degrees), and the sense of its θ: from the arm's
/// length at rest, and from how headings turn while positions do. `raw` is as the wire has it.
/// @return a tracker of which nothing else is known
/// @throws CalibrationRefused where the bodies are not the arm's plates in their order, with the
/// order that would fit, or no unit fits.
TrackerCalibration tracker_units(const ArmDescription& arm, const SeenPoses& raw,
                                 const CalibrationLog& log);

}  // namespace limber
