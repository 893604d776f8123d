#pragma once

#include <memory>

#include "limber/planning/planner.hpp"

namespace limber {

/// `planner`, its plans certified (planning/certificate.hpp) before they are called solved; a
/// certified plan carries the certificate's figures into its file. The search works in float32 and
/// the certificate in double, so it is given a little less room than was asked for: 0.1 mm more of
/// clearance (0.2 mm where no margin is asked for), 0.1 mm and 1 mrad less of the goal's
/// tolerances (at most a tenth of them). A plan that is refused all the same is a defect of the
/// planner, or of a model that amplifies rounding: its status is `not_certified`, and it is kept as
/// `best_partial`.
std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner);

}  // namespace limber
