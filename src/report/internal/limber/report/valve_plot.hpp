#pragma once

#include <string>

#include "limber/arm/characterisation.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// Contraction over pressure: the bench points of every segment and the curve fitted to them, up to
/// the pressure limit. `bench` is what `result` was fitted to.
Chart bench_chart(const CharacterisedArm& result, const BenchData& bench);

/// Set points, measured and modelled pressures of a motion that the valves were not fitted to, one
/// chart per segment, as SVG text. It shows the held-back stretch whose set points change most.
/// With ideal valves, it shows set points and measured pressures alone.
/// @throws InputError if nothing of the recording is held back.
std::string valve_plot_svg(const ValveParameters& valves, const Recording& recording);

}  // namespace limber
