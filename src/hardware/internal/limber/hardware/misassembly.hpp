#pragma once

#include <cstdint>

#include "limber/arm/arm_description.hpp"
#include "limber/hardware/wire_calibration.hpp"

namespace limber {

/// An arm put together wrongly, for trying `limber driver calibrate`: channels and sensors crossed
/// and turned, readings off zero, a tracker in another place, unit and sense, marker bodies beside
/// their plates, and shapes that come late.
struct Misassembly {
  WireCalibration truth;           ///< what a calibration has to find
  double tracker_latency_s = 0.0;  ///< shapes are so much older than pressures
  double driver_ahead_s = 0.0;     ///< the driver's clock is ahead of the arm's time
  double tracker_ahead_s = 0.0;    ///< the tracker's clock is ahead of the driver's
};

/// Sampled by the seed: the same one gives the same.
Misassembly draw_misassembly(const ArmDescription& arm, std::uint64_t seed);

}  // namespace limber
