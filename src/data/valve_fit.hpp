#pragma once

#include <vector>

#include "limber/arm/valve_parameters.hpp"
#include "valve_run.hpp"

namespace limber {

/// The valves that explain the measured pressures of `runs` best, by output error: whole runs
/// simulated from their set points, never corrected (docs/valves.md, (P5)). Deterministic.
/// @param limit_kpa  largest command, the scale of what counts as small.
/// @pre runs is not empty, and each has two frames at least.
SegmentValves fit_valves(const std::vector<ValveRun>& runs, bool has_sides, double rate_hz,
                         double limit_kpa);

}  // namespace limber
