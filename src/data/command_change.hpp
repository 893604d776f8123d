#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Whether a channel's command says anything: whether it changes by more than 2 % of half its
/// range, over all episodes and in means of half a second, so that a sensor's noise is no motion;
/// or whether it swings faster than that.
bool command_changes(const ArmDescription& arm, const std::vector<Episode>& episodes, int channel);

}  // namespace limber
