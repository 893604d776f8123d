#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/sim/virtual_arm.hpp"

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

/// What a served virtual arm's driver sees and says where the arm was put together wrongly; without
/// a misassembly the same as the arm. Threads: one at a time.
class MisassembledWire {
 public:
  /// Watches `arm`, which has to outlive it, so that shapes can come late.
  /// @param options    of `arm`: bodies in 3D have its noise across the plane too
  /// @param real_time  states then have the wall clock's time
  MisassembledWire(std::optional<Misassembly> misassembly, VirtualArm& arm,
                   const VirtualArmOptions& options, bool real_time);

  /// The arm's set points of the wire's.
  Pressures from_wire(const Pressures& setpoint_kpa) const;
  /// The wire's state of the arm's, and its limits.
  ArmState to_wire(ArmState state) const;
  std::vector<PressureLimits> to_wire(std::vector<PressureLimits> limits_kpa) const;
  /// What a tracker that sees in 3D says in place of a state's backbone, with noise of its own.
  std::optional<BodyPoses> bodies(const ArmState& on_wire);

 private:
  std::optional<Misassembly> misassembly_;
  VirtualArmOptions options_;
  RandomStream chance_;
  bool real_time_;
  std::deque<std::pair<double, BackboneD>> seen_;  // at each of the arm's steps
};

}  // namespace limber
