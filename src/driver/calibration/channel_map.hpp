#pragma once

#include <vector>

#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "seen_poses.hpp"

namespace limber {

/// Fills `zero_kpa` and `noise_kpa`: mean and standard deviation of each reading at rest.
void take_rest_pressures(const CalibrationLog& log, WireCalibration& calibration);

/// Which channel is which side of which segment. `poses`: in metres, θ counter-clockwise seen from
/// above. @throws CalibrationRefused where a channel moves nothing, two move the same segment, or
/// the two sides of a channel move different segments: with the hoses that would fit.
std::vector<WireChannel> valve_channels(const ArmDescription& arm, const CalibrationLog& log,
                                        const SeenPoses& poses);

/// Which reading is which segment's pressure, once the valves are known.
/// @param zero_kpa  of each reading, at rest
/// @throws CalibrationRefused also where a reading's scale is another unit's.
std::vector<WireChannel> sensor_channels(const ArmDescription& arm, const CalibrationLog& log,
                                         const std::vector<WireChannel>& valves,
                                         const std::vector<double>& zero_kpa);

}  // namespace limber
