#pragma once

#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// Smallest, largest, mean and standard deviation of one figure over an ensemble's networks.
struct MemberFigures {
  double min_m = 0.0;
  double max_m = 0.0;
  double mean_m = 0.0;
  double standard_deviation_m = 0.0;  ///< the members' own, divided by N
};

/// How far apart the networks put some plates at one frame.
struct SpreadAt {
  int frame = -1;
  int plate = -1;                     ///< the plate of these that is farthest apart
  double largest_distance_m = 0.0;    ///< between two networks' positions of that plate
  double standard_deviation_m = 0.0;  ///< root of the mean squared distance from its mean position
};

/// What each network of an ensemble makes of a plan by itself: all of them start from the plan's
/// first backbone and follow its predicted pressures, each with a backbone of its own.
struct PlanSpread {
  int members = 0;
  MemberFigures goal_distance;  ///< of the tips at the end
  SpreadAt end;                 ///< over all plates of the last frame
  /// Where the plan itself comes nearest to an obstacle; none without obstacles.
  struct Closest {
    SpreadAt at;  ///< over the two plates beside the gap that is nearest
    int gap = -1;
    int obstacle = -1;        ///< index in the environment's list
    MemberFigures clearance;  ///< smallest of the whole motion, of any gap, from any obstacle
  };
  std::optional<Closest> closest;
};

/// None where the model is one network, or where one of its networks predicts no finite shape.
/// @pre the plan has frames, of this arm
/// @throws InputError if the model is of another arm.
std::optional<PlanSpread> plan_spread(const Plan& plan, const ArmDescription& arm,
                                      const CompensationModel& model,
                                      const Environment& environment);

}  // namespace limber
