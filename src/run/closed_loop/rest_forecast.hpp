#pragma once

#include <functional>

#include "limber/forward/motion_simulator.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// What becomes of an arm that follows set points from a state.
struct RestForecast {
  Pose end;               ///< of the tip, after the last of them
  int unsafe_frame = -1;  ///< first whose motion keeps less than was asked for, from 0; −1: none
  int unsafe_obstacle = -1;  ///< the obstacle it is too near to

  bool is_safe() const { return unsafe_frame < 0; }
};

/// Simulates set points frame by frame, with the clearance of every motion between frames.
/// @param setpoint_kpa  of frame k = 0 … frames − 1, the arm being in that state before it
/// @param needed_m  what has to be kept from obstacles, beyond the checker's own margins
RestForecast forecast(
    const MotionModel& model, const CollisionChecker& checker, MotionState state,
    std::size_t frames,
    const std::function<Pressures(std::size_t k, const MotionState& before)>& setpoint_kpa,
    double needed_m);

}  // namespace limber
