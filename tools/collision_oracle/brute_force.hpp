#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// What dense sampling says of a motion and one obstacle: the smallest distance among the samples
/// is not below the true clearance, and above it by at most `error_m`.
struct SampledClearance {
  double value_m = 0.0;
  double error_m = 0.0;
  Eigen::Vector2d point;  ///< on the arm's middle line, where it was found
};

/// Distance of a point from an obstacle, negative inside; written for this tool alone.
double brute_force_distance(const Obstacle& obstacle, const Eigen::Vector2d& p);

/// Samples the moving arm `spacing_m` apart in space and time. Gaps that even a coarse sampling
/// shows to be farther away than another are left out.
SampledClearance brute_force_clearance(const ArmDescription& arm, const Backbone& from,
                                       const Backbone& to, const Obstacle& obstacle,
                                       double spacing_m);

}  // namespace limber
