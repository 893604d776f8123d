#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/lab/plan_spread.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// What another model makes of a plan's set points: a rehearsal, for arms without a virtual twin.
struct OtherJudgement {
  std::string model;     ///< its file
  bool is_shape = true;  ///< false: it predicts a shape that no arm has, and nothing else is known
  bool reaches_goal = false;
  bool collides = false;
  double goal_distance_m = 0.0;
  double clearance_m = 0.0;  ///< +∞ without obstacles
  double departure_m = 0.0;  ///< largest distance of a plate from where the plan puts it

  /// Where the file is an ensemble; everything above is its first network's.
  std::optional<PlanSpread> spread;

  bool agrees() const { return is_shape && reaches_goal && !collides; }
};

/// Rolls out `plan` on the network of `model_file`, by the certificate's own simulation, from its
/// start through its set points. Obstacles need only not be touched: margins are the plan's
/// model's business. A network that learnt from set points is asked with them.
/// @param valves  the plan's; null: its own model learnt from set points, so that the other one's
///                own valves are used.
/// @throws InputError where the network or the plan is of another arm.
OtherJudgement judge_by(const std::string& model_file, const Plan& plan, const ArmDescription& arm,
                        const ValveParameters* valves, const Environment& environment);

nlohmann::ordered_json to_json(const OtherJudgement& judgement);
std::string to_text(const OtherJudgement& judgement);

}  // namespace limber
