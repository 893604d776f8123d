#pragma once
// For those who plan.

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_model.hpp"

namespace limber {

/// Frames of the hold behind a motion that ends in the valve state `valves`: kHoldS, or as long as
/// the pressures take to come, and stay, within 1 % of their limits of the set points (within the
/// valves' dead band, where that is wider), up to kLongestHoldS.
int hold_frame_count(const ArmDescription& arm, const ValveModel& valves,
                     const Eigen::Ref<const Eigen::VectorXf>& state);

/// Time that the arm holds its last set points at least, before the goal is judged; execution does
/// the same.
inline constexpr double kHoldS = 1.0;
inline constexpr double kLongestHoldS = 60.0;

}  // namespace limber
