#pragma once
// For those who plan.

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"

namespace limber {

/// Set points that a search may use: each lies between a lowest and a highest one.
struct PressureBox {
  Pressures low_kpa;   ///< size n
  Pressures high_kpa;  ///< size n, ≥ low_kpa

  /// The nearest set points inside.
  Pressures limited(const Pressures& kpa) const { return kpa.cwiseMax(low_kpa).cwiseMin(high_kpa); }
  /// A uniform sample.
  Pressures sample(RandomStream& random) const;
  /// The intersection of both. @pre not empty
  PressureBox within(const PressureBox& other) const;
};

/// Between the arm's limits.
PressureBox pressure_box(const ArmDescription& arm);
/// Between other limits, one of each segment.
PressureBox pressure_box(const std::vector<PressureLimits>& limits);

/// Largest pressure of each segment, of either side.
Pressures pressure_limits_kpa(const ArmDescription& arm);
/// Half the width of each segment's limits: what searches measure distances between set points in.
/// Of symmetric limits the limit.
Pressures pressure_scales_kpa(const ArmDescription& arm);
/// What a step that was chosen in kPa, on arms of ± 100 kPa, is multiplied with to be one of this
/// arm's command: 1 where that is a pressure in kPa, else the mean pressure scale's share of 100.
double command_per_kpa(const ArmDescription& arm);

}  // namespace limber
