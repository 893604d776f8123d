#pragma once

#include <vector>

#include "limber/arm/characterisation.hpp"
#include "limber/data/recording.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// Change of a side's length over the segment's length at rest, negative where it contracts:
/// docs/model.md, (3) and (4). Lengths are those of arcs from plate to plate, so that where marker
/// bodies sit along the segment does not count.
/// @param rest, bent  m×3, of one segment
/// @param side        1: the right one, −1: the left one
double side_strain(const Backbone& rest, const Backbone& bent, double width_m, double side);

/// @throws InputError where the arm has more than one: on a driver, that one alone is mounted.
void require_one_segment(const ArmDescription& arm);

/// The bench test of one free segment that is mounted and tracked: each side goes up to its limit
/// and down again in `steps` equal steps, held until the segment stands still for what a tracker
/// tells. Set points keep the arm's rate limit.
///
/// @param limits   in force
/// @param steps    ≥ 4, of a side
/// @param episode  everything commanded and measured, also where this throws
/// @throws as `require_one_segment`; SystemFault where the driver fails or
/// the segment is not tracked; Interrupted.
std::vector<BenchPoint> measure_segment(const ArmDescription& arm, const PressureLimits& limits,
                                        int steps, ArmDriver& driver, Episode& episode);

}  // namespace limber
