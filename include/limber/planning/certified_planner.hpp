#pragma once

#include <memory>

#include "limber/planning/planner.hpp"

namespace limber {

/// Whether a planner's problem keeps the valves that it comes with.
enum class Valves { as_given, left_out };

/// `planner`, its plans certified (planning/certificate.hpp) before they are called solved; a
/// certified plan carries the certificate's figures into its file. The search works in float32 and
/// the certificate in double, so it is given a little less room than was asked for: 0.1 mm more of
/// clearance (0.2 mm where no margin is asked for), 0.1 mm and 1 mrad less of the goal's
/// tolerances (at most a tenth of them). A plan that is refused all the same is a defect of the
/// planner, or of a model that amplifies rounding: its status is `not_certified`, and it is kept as
/// `best_partial`.
/// @param valves  left_out: plans and certifies as if pressures were the set points, as the paper
/// does
std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner,
                                                Valves valves = Valves::as_given);

}  // namespace limber
