#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/network/learnt_region.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"

namespace limber {

/// What `episodes` hold: ranges of pressures and their rates, by how much the joint vector changes
/// over a frame, and its ranges along its principal axes, each widened by kAxisWidening or, where
/// one half of the episodes lies farther beyond the other half, by as much (docs/training.md).
/// Frames in which the arm was not tracked don't count. @throws InputError if it was tracked in
/// none.
LearntRegion learnt_region_of(const std::vector<Episode>& episodes);

/// The union of `region` and of what `episodes` hold: every range is widened to hold both, along
/// the axes of `region`, which stay. The same region if it held everything already.
LearntRegion widened_by(LearntRegion region, const std::vector<Episode>& episodes);

/// `region`, with its axes' ranges, and how shapes change over a frame, widened by the shapes in
/// `episodes`, in those frames whose pressures it holds, and as much farther as learnt_region_of()
/// does. Its pressures and rates stay, because a predicted frame teaches nothing.
LearntRegion with_shapes_of(LearntRegion region, std::vector<Episode> episodes);

/// Smallest share of its half range by which an axis' border lies outside of the frames.
inline constexpr double kAxisWidening = 0.1;

}  // namespace limber
