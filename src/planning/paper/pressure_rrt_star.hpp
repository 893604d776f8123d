#pragma once

#include <memory>
#include <string>

#include "limber/planning/planner.hpp"

namespace limber {

/// The paper's planner (IV-D and IV-E): RRT* over states (q, B); with valves, q is set points and
/// pressures. A new configuration is reached from the cheapest of the near nodes whose motion is
/// free. A node is rewired only if the new path ends at the same pressures and the same backbone,
/// and everything downstream, simulated again, stays free. Near nodes are sorted by the cost, known
/// beforehand, and simulated from the cheapest on; as written, all are simulated and then sorted:
/// the same tree from nine times the queries.
///
/// @param name  the planner's name in plans
std::unique_ptr<Planner> make_pressure_rrt_star(std::string name = "paper");

}  // namespace limber
