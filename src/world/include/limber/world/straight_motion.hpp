#pragma once
// For those who plan.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"

namespace limber {

using PressuresRef = Eigen::Ref<const Pressures>;

/// Cost, (2), of a straight motion in pressure: Σ|Δp|.
double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa);

/// Cost, (2), along straight motions from each point of a path to the next. Points are set points,
/// or hold some: path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa).
template <typename Point, typename SetpointOf = std::identity>
double path_cost_kpa(const std::vector<Point>& path, const SetpointOf& setpoint_of = {}) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    cost +=
        motion_cost_kpa(std::invoke(setpoint_of, path[i - 1]), std::invoke(setpoint_of, path[i]));
  }
  return cost;
}

/// The frame rule: a straight motion in pressure takes the smallest number of frames in which no
/// segment moves faster than the arm's rate limit, ⌈max |Δp| / step⌉, at least one.
/// @param step_limit_kpa  largest change of a pressure in one frame, > 0
int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa);

/// Set points of frame k of a straight motion of `count` frames, 1 ≤ k ≤ count, in equal steps,
/// written to `setpoint_kpa`; the last is exactly `to_kpa`. Sizes n.
void motion_setpoint(const PressuresRef& from_kpa, const PressuresRef& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa);

/// Those of all its frames, by the frame rule: at least one, the last exactly `to_kpa`.
std::vector<Pressures> straight_setpoints(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                                          double step_limit_kpa);

}  // namespace limber
