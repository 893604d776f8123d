#pragma once

#include <vector>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Finds where a tracker mistook a body's rotation: it jumps by more than its neighbours in time
/// allow while the body's place does not. A single such row is hidden. A jump of more than 30
/// degrees that lasts is a body whose markers were mixed up, or that was defined again: such rows
/// are turned back to what most rows of the body show. A smaller jump is left. Of the base, whose
/// rotation says only where the frame is, single rows are turned back, too.
/// @param length_m       of the arm
/// @param longest_gap    over longer silences nothing is compared
/// @return one for each body in which there were some
std::vector<SpaceFlips> settle_rotations(double length_m, const LongestGap& longest_gap,
                                         SpaceTracks& tracks);

/// The same of headings in a plane, where a jump is one of more than a radian. What was found is
/// noted. @pre tracks have headings
void settle_headings(double length_m, const LongestGap& longest_gap, PointTracks& tracks,
                     RunReport& report);

}  // namespace limber
