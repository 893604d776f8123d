#pragma once

#include <optional>

#include "limber/run/appearing_obstacle.hpp"
#include "limber/sim/disturbance.hpp"

namespace limber {

/// The one of `limber execute --disturbance obstacle`; none where none is wanted, or fits the plan.
inline std::optional<AppearingObstacle> dropped_obstacle(bool wanted, const ArmDescription& arm,
                                                         const Plan& plan) {
  if (!wanted) {
    return std::nullopt;
  }
  return disturbed(arm, plan, parse_disturbances("obstacle"), plan.seed).obstacle;
}

}  // namespace limber
