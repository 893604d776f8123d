#pragma once

#include <optional>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

struct RandomEnvironmentSettings {
  int min_obstacles = 2;
  int max_obstacles = 5;
  double clearance_m = 0.01;  ///< of the witness motion, ≥ 0
  double position_tolerance_m = 0.02;
  double orientation_tolerance_rad = 0.3;
  double orientation_share = 0.3;  ///< of environments whose goal asks for a heading
  int attempts = 1000;             ///< motions sampled before giving up, ≥ 1
  /// Where the arm rests; none: straight, all pressures zero. It is not checked: what no plan can
  /// start from gives no plan.
  std::optional<ArmStart> start = std::nullopt;
};

/// An environment, and one motion that solves it as the model predicts.
struct RandomEnvironment {
  Environment environment;
  std::vector<Pressures> witness_kpa;  ///< waypoints, start first
};

/// Draws an environment about a motion of the model that will plan in it, for those who learn from
/// executed plans: the arm may be any, and start under pressure. The arm starts free and at rest. A
/// motion through random waypoints, simulated with `model`, stays clear of every obstacle, and the
/// goal is where its tip ends after the hold. The straight motion in pressure to the same end
/// collides, and no straight motion to an inverse-kinematics solution solves the environment.
/// @param number  of the environment among those of `seed`; part of its name
/// @return none if `attempts` did not give one
std::optional<RandomEnvironment> random_environment(
    const ArmDescription& arm, const MotionModel& model, std::uint64_t seed, std::uint64_t number,
    const RandomEnvironmentSettings& settings = RandomEnvironmentSettings());

}  // namespace limber
