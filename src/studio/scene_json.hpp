#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

// What pages and scripts get (docs/studio_api.md). Keys are those of limber's files.

nlohmann::ordered_json arm_to_json(const ArmDescription& arm);

nlohmann::ordered_json obstacle_to_json(const Obstacle& obstacle);
/// The keys of the environment's file; `environment_from_json` is the inverse.
nlohmann::ordered_json environment_to_json(const Environment& environment);
/// @throws InputError naming field, what was found and what is allowed.
Environment environment_from_json(const nlohmann::json& json, const ArmDescription& arm);

/// A shape's 3m numbers, to 0.01 mm and 0.0001 rad: far below a pixel.
nlohmann::ordered_json shape_to_json(const Eigen::Ref<const Backbone>& backbone);
/// To 0.01 mm; null if it is not finite.
nlohmann::ordered_json length_to_json(double length_m);
/// To 0.001 of the unit.
nlohmann::ordered_json pressures_to_json(const Eigen::Ref<const Pressures>& kpa);
nlohmann::ordered_json plan_to_json(const Plan& plan);
nlohmann::ordered_json progress_to_json(const PlannerProgress& progress);
/// Tips of nodes and of their parents, flat; the oldest `max_edges`.
nlohmann::ordered_json tree_to_json(const std::vector<TreeEdge>& tree, std::size_t max_edges);

/// Middles of cells that the tip of the unloaded arm reaches at rest, flat (x_m, y_m …), and their
/// width: sampled, with a fixed seed.
nlohmann::ordered_json reach_to_json(const ArmDescription& arm);

}  // namespace limber
