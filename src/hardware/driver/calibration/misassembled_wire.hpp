#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "limber/hardware/misassembly.hpp"
#include "limber/hardware/virtual_arm.hpp"

namespace limber {

/// What a served virtual arm's driver sees and says where the arm was put together wrongly; without
/// a misassembly the same as the arm. Threads: one at a time.
class MisassembledWire {
 public:
  /// Watches `arm`, which has to outlive it, so that shapes can come late.
  /// @param real_time  states then have the wall clock's time
  MisassembledWire(std::optional<Misassembly> misassembly, VirtualArm& arm, bool real_time);

  /// The arm's set points of the wire's.
  Pressures from_wire(const Pressures& setpoint_kpa) const;
  /// The wire's state of the arm's, and its limits.
  ArmState to_wire(ArmState state) const;
  std::vector<PressureLimits> to_wire(std::vector<PressureLimits> limits_kpa) const;
  /// When the shape of a state was seen, on the tracker's clock.
  std::optional<double> tracker_s(const ArmState& on_wire) const;

 private:
  std::optional<Misassembly> misassembly_;
  bool real_time_;
  std::deque<std::pair<double, BackboneD>> seen_;  // at each of the arm's steps
};

}  // namespace limber
