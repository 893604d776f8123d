#pragma once

#include <memory>

#include "limber/planning/planner.hpp"

namespace limber {

/// Whether a planner's problem keeps the valves that it comes with.
enum class Valves { as_given, left_out };

/// `planner`, its plans certified (certificate/certificate.hpp) before they are called solved; a
/// certified plan carries the certificate's figures into its file. The search works in float32 and
/// the certificate in double, so it is given a little less room than was asked for: 0.1 mm more of
/// clearance (0.2 mm where no margin is asked for), 0.1 mm and 1 mrad less of the goal's
/// tolerances (at most a tenth of them). Certificates are given while the planner searches
/// (PlanJudge), so a plan that is refused takes no other along; where every plan is refused the
/// status is `not_certified`, and the cheapest is kept as `best_partial`.
///
/// The goal's margin is taken off its tolerances, down to half of them, and if there is one the
/// inner quarter is aimed at. Where nothing keeps the clearance asked for, the last tenth of the
/// limits (at most a second) goes to smaller ones, and the reason names the largest that gave a
/// plan.
/// @param valves  left_out: plans and certifies as if pressures were the set points, as the paper
/// does
std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner,
                                                Valves valves = Valves::as_given);

}  // namespace limber
