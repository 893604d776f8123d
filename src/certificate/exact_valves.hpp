#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"

namespace limber {

/// The valve model once more, from docs/valves.md and nothing else: in double precision and
/// continuous time, from one event to the next. Slow on purpose; the certificate holds the fast one
/// to it.
class ExactValves {
 public:
  using Configurations = std::vector<std::vector<double>>;  ///< a frame each, n numbers

  /// Borrows both.
  ExactValves(const ArmDescription& arm, const ValveParameters& valves)
      : arm_(arm), valves_(valves) {}

  /// Pressures at the end of each frame. Frame 0 is the start, where the arm has long stood at its
  /// set points; frame k's set points are commanded at its beginning, (k − 1)/rate.
  Configurations pressures_along(const Configurations& setpoints_kpa) const;

 private:
  std::vector<double> segment_pressures(const SegmentValves& valves,
                                        const std::vector<double>& setpoints_kpa) const;

  const ArmDescription& arm_;
  const ValveParameters& valves_;
};

}  // namespace limber
