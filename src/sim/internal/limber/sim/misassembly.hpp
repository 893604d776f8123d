#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/wire_calibration.hpp"

namespace limber {

/// An arm put together wrongly, for trying `limber driver calibrate`: channels and sensors crossed
/// and turned, readings off zero, a tracker in another place, unit and sense, marker bodies beside
/// their plates, and shapes that come late.
struct Misassembly {
  WireCalibration truth;           ///< what a calibration has to find
  double tracker_latency_s = 0.0;  ///< shapes are so much older than pressures
  double driver_ahead_s = 0.0;     ///< the driver's clock is ahead of the arm's time
  double tracker_ahead_s = 0.0;    ///< the tracker's clock is ahead of the driver's
  /// Of each body above the truth's plane, in the tracker's unit; empty where there is none.
  Eigen::VectorXd body_heights;
};

/// Sampled by the seed: the same one gives the same.
Misassembly draw_misassembly(const ArmDescription& arm, std::uint64_t seed);

/// The same but for the tracker's angles: it sees in 3D, turned and moved at random, and each body
/// has a height and axes of its own. The normal's largest component is positive; it points down
/// where the tracker is mirrored.
Misassembly draw_misassembly_in_3d(const ArmDescription& arm, std::uint64_t seed);

}  // namespace limber
