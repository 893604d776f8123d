#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"

namespace limber {

/// The valve model once more, written from docs/valves.md alone: in double precision and continuous
/// time, from one event to the next. It is slow on purpose; the certificate checks the fast model
/// against it.
class ExactValves {
 public:
  using Configurations = std::vector<std::vector<double>>;  ///< one per frame, n numbers

  /// Borrows both.
  ExactValves(const ArmDescription& arm, const ValveParameters& valves)
      : arm_(arm), valves_(valves) {}

  /// Pressures at the end of each frame. Frame 0 is the start, where the arm has settled at its set
  /// points; frame k's set points are commanded at its beginning, (k − 1)/rate.
  Configurations pressures_along(const Configurations& setpoints_kpa) const;

 private:
  std::vector<double> segment_pressures(const SegmentValves& valves,
                                        const std::vector<double>& setpoints_kpa) const;

  const ArmDescription& arm_;
  const ValveParameters& valves_;
};

}  // namespace limber
