#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/network/prediction_error.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// How far an executed plan was from its prediction (docs/tube.md, (1)).
struct MotionErrors {
  std::vector<double> plate_m;  ///< largest over the plan's frames, one per plate
  double end_m = 0.0;           ///< of the tip at the run's end, after the hold
  double end_heading_rad = 0.0;
};

/// Frame k of the run beside frame k of the plan; what is held longer than planned beside its last.
/// @pre the run is that plan's, open loop: run_of_plan
MotionErrors motion_errors(const Plan& plan, const Episode& run);

/// (2): the largest of error over scale, over plates, the middles of gaps and frames, and over tip
/// and heading at the run's end. The run is inside a tube if its score does not exceed the factor.
double tube_score(const Plan& plan, const Episode& run, const Tube& shape);

/// Shape of a tube, without levels (docs/tube.md, (3)): what 90 % of the runs stay below, at each
/// plate, and how the tip's error grows with the frame.
/// @pre at least one run; all of one arm
Tube tube_shape(const std::vector<MotionErrors>& runs);

}  // namespace limber
