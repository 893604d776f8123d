#pragma once

#include <string>

#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Set points, measured and modelled pressures of a motion that the valves were not fitted to, one
/// chart per segment, as SVG text. It shows the held-back stretch whose set points change most.
/// With ideal valves, it shows set points and measured pressures alone.
/// @throws InputError if nothing of the recording is held back.
std::string valve_plot_svg(const ValveParameters& valves, const Recording& recording);

}  // namespace limber
