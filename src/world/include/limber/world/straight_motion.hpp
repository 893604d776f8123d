#pragma once
// For those who plan.

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

using PressuresRef = Eigen::Ref<const Pressures>;

/// The frame rule: a straight motion in pressure takes the smallest number of frames in which no
/// segment moves faster than the arm's rate limit, ⌈max |Δp| / step⌉, at least one.
/// @param step_limit_kpa  largest change of a pressure in one frame, > 0
int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa);

/// (2) of a straight motion: Σ|Δp|.
double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa);

/// (2) along straight motions from each of these set points to the next.
double path_cost_kpa(const std::vector<Pressures>& waypoints_kpa);

/// Set points of frame k of a straight motion of `count` frames, 1 ≤ k ≤ count, in equal steps,
/// written to `setpoint_kpa`; the last is exactly `to_kpa`. Sizes n.
void motion_setpoint(const Eigen::Ref<const Pressures>& from_kpa,
                     const Eigen::Ref<const Pressures>& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa);

/// Set points of the frames from `from` to `to`, `to` included and `from` not: evenly along the
/// straight line, as many as the frame rule above says.
std::vector<Pressures> straight_frames(const ArmDescription& arm, const Pressures& from,
                                       const Pressures& to);

}  // namespace limber
