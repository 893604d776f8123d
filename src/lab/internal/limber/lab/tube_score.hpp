#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/network/tube_shape.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// Which frame of the plan each frame of its run shows, as its set point in force says: a driver
/// that answers at once is one behind. What is held longer than planned shows the last one.
std::vector<int> shown_frames(const Plan& plan, const Episode& run);

/// Each frame of the run beside the plan's that it shows.
/// @pre the run is that plan's, open loop
MotionErrors motion_errors(const Plan& plan, const Episode& run, const RoomGrowth& growth = {});

/// The same for each growth that a tube may have.
GrowingErrors growing_errors(const Plan& plan, const Episode& run, double arm_length_m);

/// (3): the largest of error over scale, over plates, the middles of gaps and frames, and over tip
/// and heading at the run's end. The run is inside a tube if its score does not exceed the factor.
double tube_score(const Plan& plan, const Episode& run, const Tube& shape);

/// The tube's radius at the tip, on average over the plan's frames.
double mean_tip_radius_m(const Plan& plan, const Tube& tube, const TubeLevel& level);

}  // namespace limber
