#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"

namespace limber {

struct RandomEnvironmentSettings {
  double clearance_m = 0.01;  ///< of the witness motion, ≥ 0
  int attempts = 1000;        ///< motions sampled before giving up, ≥ 1
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
/// collides, and no straight motion to an inverse-kinematics solution solves the environment. There
/// are 2 to 5 obstacles.
/// @param number  of the environment among those of `seed`; part of its name
/// @return none if `attempts` did not give one
std::optional<RandomEnvironment> random_environment(
    const ArmDescription& arm, const MotionModel& model, std::uint64_t seed, std::uint64_t number,
    const RandomEnvironmentSettings& settings = RandomEnvironmentSettings());

/// Shapes (m×3) of an arm that starts at rest, goes straight in pressure to one set points after
/// another, and holds the last ones as a plan does; so close in time that it moves straight from
/// each to the next. The first shape is at rest, the last one at the end of the hold.
using Witness = std::function<std::vector<Backbone>(const std::vector<Pressures>& waypoints_kpa)>;

/// The virtual arm, a shape every hundredth of a second. Borrows the arm.
/// @throws InputError if there is none of this arm: it is not driven by pressures.
Witness virtual_witness(const ArmDescription& arm);

/// An arm that does what a model says, a shape in every frame. Borrows the arm, and what the model
/// borrows.
Witness model_witness(const ArmDescription& arm, const MotionModel& model);

/// An environment about one motion of an arm, and the set points of that motion.
struct WitnessedEnvironment {
  Environment environment;
  double clearance_m = 0.0;              ///< that every obstacle keeps from every shape, at least
  std::vector<Pressures> waypoints_kpa;  ///< where the motion goes from rest, one after another
};

/// A random environment that no planner and no model has chosen (docs/environments.md). The witness
/// moves from rest by one to three straight motions, and the goal is where its tip ends. 5 to 13
/// obstacles lie within 16 cm of its shapes, and 1.2 or 2 cm clear of all of them, and of what is
/// between them. Lengths are for the paper's arm, and grow with others. Depends on its arguments
/// alone.
/// @param number  of the environment among those of `seed`; part of its name
/// @return none for an arm whose tip stays where it is in a hundred motions
std::optional<WitnessedEnvironment> witnessed_environment(const ArmDescription& arm,
                                                          const Witness& witness,
                                                          std::uint64_t seed, std::uint64_t number);

}  // namespace limber
