#pragma once

#include <vector>

#include "limber/arm/backbone.hpp"

namespace limber {

/// What one log says of where the base is. An arm whose points have no headings leaves its base
/// along `base.theta_rad` − share · `turn_rad`, where the share is the arm's own.
struct BaseSighting {
  Pose base;                   ///< median position; mean heading, or direction to the next point
  double turn_rad = 0.0;       ///< mean turn at that point; 0 where headings were measured
  double arc_share = 0.0;      ///< of an arc, which bends evenly
  double products = 0.0;       ///< how many, of these sums over pairs of rows, about the means:
  double turn_products = 0.0;  ///< turn · the other's turn
  double direction_products = 0.0;  ///< direction · the other's turn
};

/// Each log's base, the share taken from all of them. @pre at least one
std::vector<Pose> bases_of(const std::vector<BaseSighting>& sightings);

}  // namespace limber
