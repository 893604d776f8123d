#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// An obstacle that is there from some frame of a run on. Where exactly depends on where the arm
/// is by then: the first of `circles` that is far enough from it.
struct AppearingObstacle {
  static constexpr double kAheadS = 1.0;   ///< the plan is free of it for at least so long
  static constexpr double kAheadM = 0.05;  ///< and the arm at least so far from it

  int frame = 0;                ///< of the run, counted from its start
  std::vector<Circle> circles;  ///< in the order that they were sampled
};

/// Samples a frame of the plan's motion and, on the rest of its path, circles around points
/// that the arm's tip passes later, at least kAheadS after the frame. None if the motion is
/// shorter than that, or 100 samples gave no circle.
std::optional<AppearingObstacle> appearing_obstacle(const ArmDescription& arm, const Plan& plan,
                                                    double radius_m, std::uint64_t seed,
                                                    std::uint64_t stream);

/// The first circle at least kAheadM from the arm's outside; none if all are nearer.
std::optional<Circle> circle_ahead_of(const ArmDescription& arm, const AppearingObstacle& obstacle,
                                      const BackboneD& backbone);

}  // namespace limber
