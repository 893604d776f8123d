#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "seen_poses.hpp"

namespace limber {

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
                     ClockCalibration& clocks);

}  // namespace limber
