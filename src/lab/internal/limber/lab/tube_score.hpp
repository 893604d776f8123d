#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/network/prediction_error.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// How far an executed plan was from its prediction (docs/tube.md, (1)).
struct MotionErrors {
  /// Largest over the plan's frames, one per plate, each over the share of its room that the plate
  /// has there.
  std::vector<double> plate_m;
  double end_m = 0.0;  ///< of the tip at the run's end, after the hold
  double end_heading_rad = 0.0;
};

/// Which frame of the plan each frame of its run shows, as its set point in force says: a driver
/// that answers at once is one behind. What is held longer than planned shows the last one.
std::vector<int> shown_frames(const Plan& plan, const Episode& run);

/// Each frame of the run beside the plan's that it shows.
/// @pre the run is that plan's, open loop
MotionErrors motion_errors(const Plan& plan, const Episode& run, const RoomGrowth& growth = {});

/// (3): the largest of error over scale, over plates, the middles of gaps and frames, and over tip
/// and heading at the run's end. The run is inside a tube if its score does not exceed the factor.
double tube_score(const Plan& plan, const Episode& run, const Tube& shape);

/// (2) of docs/tube.md, with limber's own numbers.
RoomGrowth usual_growth(double arm_length_m);

/// The tube's radius at the tip, on average over the plan's frames.
double mean_tip_radius_m(const Plan& plan, const Tube& tube, const TubeLevel& level);

/// Shape of a tube, without levels (docs/tube.md, (3)): what most of the runs stay below.
/// @param runs    at least one, all of one arm, with that growth
Tube tube_shape(const std::vector<MotionErrors>& runs, const RoomGrowth& growth);

}  // namespace limber
