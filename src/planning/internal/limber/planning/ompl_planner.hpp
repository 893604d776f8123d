#pragma once

#include <memory>
#include <string>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Planners of the Open Motion Planning Library on limber's forward model and collision checks, to
/// compare with (docs/planning.md, OMPL): "ompl:RRT", "ompl:SST",
/// "ompl:KPIECE1", "ompl:EST", "ompl:PDST". Empty if limber was built without OMPL.
std::vector<std::string> ompl_planner_names();

/// @param name  one of the names, and settings behind it: "ompl:SST,pruning_radius=0.05,frames=5".
///   Settings are OMPL's own parameters of the planner, and
///     frames      the longest motion under one control, in frames [1, 100], default 10
///     tip_weight  in the distance √(|Δp / limit|² + (w |Δtip| / length)²), [0, 100], default 0
///     directed    1: controls steer straight at the sampled pressures as fast as the rate allows,
///                 where the planner lets them (RRT, EST); 0: OMPL's random controls; default 1
///
/// Every frame becomes a waypoint: under OMPL a control may be slower than the rate allows. Plans
/// are built, held and judged like those of the other planners. Limits on time and queries are kept
/// to one motion; those on iterations and memory are refused, since OMPL counts neither. Seeds
/// decide limber's part (samples, controls); they decide OMPL's own draws only in the first plan of
/// a process. Unless the planner is asymptotically optimal (SST), the first solution is the last.
/// @throws InputError if the name or a setting is unknown, or limber was built without OMPL.
std::unique_ptr<Planner> make_ompl_planner(const std::string& name);

}  // namespace limber
