#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "rollout.hpp"

namespace limber {

/// Plate by plate, the largest distance between two shapes of 3m numbers each.
double max_distance_m(const Eigen::RowVectorXf& a, const Eigen::RowVectorXf& b);

/// The runs over which a model's error is measured: recorded motions, cut at kLongestErrorRun_s,
/// that move a set point; if enough of them begin with the arm at rest, only those.
std::vector<RolloutPiece> error_runs(const ArmDescription& arm, const std::vector<Episode>& unseen);

}  // namespace limber
