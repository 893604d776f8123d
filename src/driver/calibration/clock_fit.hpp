#pragma once

#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"

namespace limber {

/// limber's clock against the driver's: a sample is taken before its answer arrives, and not before
/// the request, or a frame earlier where the driver answers with what it has. Each exchange bounds
/// the offset so; a drift is taken out first. Fills `driver` and `driver_drift`.
///
/// @param frame_period_s  what a sample may be older than the request by
void fit_driver_clock(const CalibrationLog& log, double frame_period_s, ClockCalibration& clocks);

}  // namespace limber
