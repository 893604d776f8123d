#pragma once

#include <string>

#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Set points, measured and modelled pressures of a motion that the valves were not fitted to, one
/// chart a segment, as SVG text: of what is held back, the stretch whose set points change most.
/// Ideal valves: set points and measured pressures alone.
/// @throws InputError if nothing of the recording is held back.
std::string valve_plot_svg(const ValveParameters& valves, const Recording& recording);

}  // namespace limber
