#pragma once

#include <cstdint>
#include <optional>

#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// What an environment looks like.
enum class EnvironmentStyle {
  pillars,        ///< circles
  gap_in_a_wall,  ///< a wall of two rectangles with a gap, and circles
  reach_behind,   ///< rectangles and triangles between the arm and its goal
  clutter         ///< everything, concave polygons too
};

struct StyleSettings {
  EnvironmentStyle style = EnvironmentStyle::clutter;
  int waypoints = 2;               ///< of the hidden motion, its end included, 1 … 4
  bool overshoot = false;          ///< the hidden motion reverses a pressure
  bool narrow = false;             ///< the way leads through a passage that counts as narrow
  bool orientation = false;        ///< the goal asks for a heading too
  int obstacles = 5;               ///< wanted; a wall counts as two
  double min_clearance_m = 0.015;  ///< of the hidden motion, > 0
  double max_clearance_m = 0.05;
};

/// An environment with the motion it was drawn around, which solves it as the model predicts.
struct StyledEnvironment {
  Environment environment;
  Plan hidden_plan;
};

/// Draws a motion from rest, makes the pose where `model` says it ends the goal, and sets obstacles
/// close about the motion but clear of it, so that the straight line in pressure to the same end
/// collides. Depends on its arguments alone; none if this draw came to nothing (try the next
/// number).
std::optional<StyledEnvironment> draw_styled(const ArmDescription& arm, const MotionModel& model,
                                             const StyleSettings& settings, std::uint64_t seed,
                                             std::uint64_t number);

}  // namespace limber
