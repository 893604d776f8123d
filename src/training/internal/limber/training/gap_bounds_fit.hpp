#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// A gap's range, without the share kRareShare of the frames at either end, is widened by kMargin
/// of its width on both sides, and by no less than the other two.
inline constexpr double kRareShare = 0.001;
inline constexpr double kMargin = 0.25;
inline constexpr double kMinLengthMargin = 0.03;  ///< of the gap's recorded length
inline constexpr double kMinTurnMargin_rad = 0.05;

/// The bounds of (20) for predictions of an arm that moved like this: each gap's recorded lengths
/// and turns with the margins above. Frames in which the arm was not tracked don't count.
/// @throws InputError if there is no episode or no tracked frame, or they are of different arms.
GapBounds gap_bounds_of(const std::vector<Episode>& episodes);

}  // namespace limber
