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

  /// Pressures at the end of each frame. Frame 0 is the start; frame k's set points are commanded
  /// at its beginning, (k − 1)/rate.
  /// @param start_kpa   pressures at the end of frame 0: of an arm at rest its set points
  /// @param before_kpa  set points of the frames before frame 0, the newest first; the oldest of
  ///                    all that are given were in force for ever
  Configurations pressures_along(const Configurations& setpoints_kpa,
                                 const std::vector<double>& start_kpa,
                                 const Configurations& before_kpa) const;

  /// The same of an arm that has settled at its first set points.
  Configurations pressures_along(const Configurations& setpoints_kpa) const {
    return pressures_along(setpoints_kpa, setpoints_kpa.front(), {});
  }

 private:
  std::vector<double> segment_pressures(const SegmentValves& valves, double start_kpa,
                                        std::size_t before,
                                        const std::vector<double>& setpoints_kpa) const;

  const ArmDescription& arm_;
  const ValveParameters& valves_;
};

}  // namespace limber
