#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// "(0.003, 0.000) m, 0.050 rad" of a base that lies farther from the origin of frame B than
/// tracking is wrong, 2 mm or 0.01 rad; empty if it does not.
std::string base_offset(const Episode& episode);

/// Median distance of plates `plate` and `plate + 1` over the frames in which the arm was tracked;
/// NaN if it never was.
double median_gap_m(const Episode& episode, int plate);

/// "arm 'two_segment'", or "the arm" of one without a name.
std::string arm_in_words(const ArmDescription& arm);

/// @throws InputError beginning with `where` if the arm's end stands still while commands change.
/// @pre the episode has the arm's sizes
void require_motion(const Episode& episode, const ArmDescription& arm, const std::string& where);

/// @throws InputError beginning with `where`: if the plates' distances are not those of the arm, or
/// a plate is where no arm gets in some frame in which it was tracked.
/// @param slack  ≥ 1, by which the distances may be farther off
/// @pre the episode has the arm's sizes
void require_backbones_of(const Episode& episode, const ArmDescription& arm, double slack,
                          const std::string& where);

}  // namespace limber
