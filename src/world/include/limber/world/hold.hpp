#pragma once
// For those who plan.

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_model.hpp"

namespace limber {

/// Frames of the hold after a motion that ends in the valve state `valves`: kHoldS, and until the
/// pressures come, and stay, within 1 % of their limits of the set points (or within the valves'
/// dead band, if that is wider), up to kLongestHoldS.
int hold_frame_count(const ArmDescription& arm, const ValveModel& valves,
                     const Eigen::Ref<const Eigen::VectorXf>& state);

/// Shortest time that the arm holds its last set points before the goal is judged, in planning and
/// in execution.
inline constexpr double kHoldS = 1.0;
inline constexpr double kLongestHoldS = 60.0;

}  // namespace limber
