#pragma once
// For those who train and evaluate models.

#include <string>
#include <vector>

#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Frames [first, first + count) of one episode.
struct FrameRange {
  int episode = 0;
  int first = 0;
  int count = 0;
};

/// Whether the set points are merely the measured pressures, as written by an import that found no
/// set points in the log; of several, whether all are.
bool setpoints_are_measured(const Episode& episode);
bool setpoints_are_measured(const std::vector<Episode>& episodes);

/// Episodes that move and hold no set points of their own tell nothing of valves.
void leave_out_measured_setpoints(std::vector<Episode>& episodes);

/// What valves are fitted to, and what is held back to judge them: every fifth episode if there
/// are five or more, else the last fifth of each (of its changes, where it rests for most of it).
struct ValveSplit {
  std::vector<FrameRange> fitted;
  std::vector<FrameRange> held_back;
};
ValveSplit split_for_valves(const std::vector<Episode>& episodes);

/// |simulated − measured| over `ranges`, each started at its first measured pressure and never
/// corrected. A frame of a segment counts if that segment's set point has changed within the
/// last 0.5 s. For ideal valves these are the errors of taking set points for pressures.
ValveErrors valve_errors(const ValveParameters& valves, const Recording& recording,
                         const std::vector<FrameRange>& ranges);

/// Identifies the valves between set points and measured pressures of `recording`: docs/valves.md.
/// All segments share parameters if those are as good on the held-back data, else each has its own;
/// segments whose set points hardly change take those of the others. If the recording does not show
/// them, the findings say why and the parameters are ideal. Deterministic; seconds for any length.
/// @param limits_kpa  largest commands, one per segment; empty: the largest set points.
/// @throws InputError if `limits_kpa` has another size.
IdentifiedValves identify_valves(const Recording& recording, std::vector<double> limits_kpa = {});

/// The same for an arm's recordings taken together. @throws InputError as `validate`.
IdentifiedValves identify_valves(const std::vector<Episode>& episodes, const ArmDescription& arm,
                                 const std::string& source);

}  // namespace limber
