#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "limber/common/random_stream.hpp"
#include "limber/sim/misassembly.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

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
  /// When the shape of a state was seen, on the tracker's clock.

 private:
  std::optional<Misassembly> misassembly_;
  VirtualArmOptions options_;
  RandomStream chance_;
  bool real_time_;
  std::deque<std::pair<double, BackboneD>> seen_;  // at each of the arm's steps
};

}  // namespace limber
