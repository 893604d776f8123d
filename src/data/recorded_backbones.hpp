#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Mean place and heading of the base plate over the frames in which the arm was tracked; zero
/// where it never was.
Pose mean_base(const Episode& episode);

/// "(0.003, 0.000) m, 0.050 rad" of a base that lies farther from the origin of frame B than
/// tracking is wrong, 2 mm or 0.01 rad; empty if it does not.
std::string base_offset(const Episode& episode);

/// Median distance of plates `plate` and `plate + 1` over the frames in which the arm was tracked;
/// NaN if it never was.
double median_gap_m(const Episode& episode, int plate);

/// @throws InputError naming `file` and the episode: if the plates' distances are not those of
/// the arm, or where the arm's end stands still while commands change.
void require_backbones_of(const Recording& recording, const ArmDescription& arm,
                          const std::string& file);

}  // namespace limber
