#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/pressure_box.hpp"

namespace limber {

/// A plan's set points, start first: at least two.
using Waypoints = std::vector<Pressures>;

/// Where changes of waypoints lead, and how far.
struct ChangeSpace {
  Pressures scale_kpa;  ///< size n, what shifts are a fraction of
  PressureBox box;      ///< changed set points stay in there
};

/// Changes of a plan's waypoints. Each takes the waypoints and returns them changed; the start
/// stays as it is. What is random depends on the stream alone.

/// Without one to four waypoints in a row; start and end stay. @pre at least three waypoints
Waypoints without_some(Waypoints waypoints_kpa, RandomStream& random);

/// One segment's pressure runs evenly between two waypoints: the cost counts reversals only.
/// @pre at least three waypoints
Waypoints straightened(Waypoints waypoints_kpa, RandomStream& random);

/// The end is moved by `shift_kpa`, and the waypoints before it in proportion to how far along
/// they are.
Waypoints with_end_shifted(Waypoints waypoints_kpa, const ChangeSpace& space,
                           const Pressures& shift_kpa);

/// One more waypoint on the straight line between two, for later changes to move; none where there
/// are kMaxWaypoints.
Waypoints split(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random);
inline constexpr std::size_t kMaxWaypoints = 40;

/// A shift, normal, of a scale that is even in its logarithm, along all segments or one of them.
Pressures random_shift(const ChangeSpace& space, RandomStream& random);

/// Any one of those, and sometimes a split before it.
Waypoints changed(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random);

}  // namespace limber
