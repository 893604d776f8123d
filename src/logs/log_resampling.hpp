#pragma once

#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"

namespace limber {

/// Cuts two tracks on one clock into episodes at the arm's rate (docs/importing.md).
///
/// Frames lie at whole multiples of the frame period on the motion clock, as far as both tracks
/// reach. A frame lies on the straight line between the rows around it; set points jump, so it has
/// the ones in force. Where one of the rows was filled in, or one between them is missing for
/// longer than a frame, the frame is marked as not tracked. Where rows are missing for longer than
/// the longest gap, or the tracker hangs (rows_that_hang), the episode ends and another begins;
/// pieces shorter than a second are dropped and noted. Without logged set points the measured
/// commands stand for them; where nothing was measured, episodes say so (Episode::setpoints_only).
/// Motions are those logged, or begin where a set point moves (a command, where none are logged)
/// after standing still.
/// @throws InputError, its message beginning with `log`, where nothing is left.
std::vector<Episode> resample(const std::string& log, const BackboneTrack& motion,
                              const CommandTrack& commands, const ArmDescription& arm,
                              const LongestGap& longest_gap, RunReport& report);

}  // namespace limber
