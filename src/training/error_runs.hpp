#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "rollout.hpp"

namespace limber {

/// The runs over which a model's error is measured: recorded motions, cut at kLongestErrorRun_s,
/// that move a set point; if enough of them begin with the arm at rest, only those.
std::vector<RolloutPiece> error_runs(const ArmDescription& arm, const std::vector<Episode>& unseen);

}  // namespace limber
