#include "base_sighting.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

// Root mean square of the turn about its mean, below which noise would choose the share.
constexpr double kLeastTurn_rad = 0.05;

/// How much of the turn at the second point lies before it: as much as the direction to that point
/// changes with it.
double arc_share_of(const std::vector<BaseSighting>& sightings) {
  double products = 0.0;
  double turns = 0.0;
  double directions = 0.0;
  for (const BaseSighting& sighting : sightings) {
    products += sighting.products;
    turns += sighting.turn_products;
    directions += sighting.direction_products;
  }
  return turns > products * kLeastTurn_rad * kLeastTurn_rad
             ? std::clamp(directions / turns, 0.0, 1.0)
             : sightings.front().arc_share;
}

}  // namespace

std::vector<Pose> bases_of(const std::vector<BaseSighting>& sightings) {
  const double arc_share = arc_share_of(sightings);
  std::vector<Pose> bases;
  for (const BaseSighting& sighting : sightings) {
    bases.push_back(sighting.base);
    bases.back().theta_rad =
        std::remainder(sighting.base.theta_rad - arc_share * sighting.turn_rad, 2.0 * M_PI);
  }
  return bases;
}

}  // namespace limber
