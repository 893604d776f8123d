#pragma once

#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// The pressures that the valves make of the set points of `episode`, frames [first, first +
/// count): row 0 is the measured pressure of frame `first`, every other row follows from set points
/// alone, including those before `first` if the dead time reaches back to them. Never corrected.
/// @throws InputError if the parameters have another number of segments or are out of range.
/// @pre count ≥ 1; the frames are the episode's.
FrameMatrix simulate_valves(const ValveParameters& valves, double rate_hz, const Episode& episode,
                            int first, int count);

/// The same for the whole episode.
FrameMatrix simulate_valves(const ValveParameters& valves, double rate_hz, const Episode& episode);

}  // namespace limber
