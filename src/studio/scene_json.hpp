#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

// What the studio's page gets beside report/scene_json.hpp (docs/studio_api.md).

/// Of the keys of the environment's file, as `environment_to_json` writes them.
/// @throws InputError naming field, what was found and what is allowed.
Environment environment_from_json(const nlohmann::json& json, const ArmDescription& arm);

Json plan_to_json(const Plan& plan);
Json progress_to_json(const PlannerProgress& progress);
/// Tips of nodes and of their parents, flat; the oldest `max_edges`.
Json tree_to_json(const std::vector<TreeEdge>& tree, std::size_t max_edges);

/// Middles of cells that the tip of the unloaded arm reaches at rest, flat (x_m, y_m …), and their
/// width: sampled, with a fixed seed.
Json reach_to_json(const ArmDescription& arm);

/// How many numbers e tell arms of the model's family apart, those of the model's own arm, and what
/// e tells of physics (docs/studio_api.md).
Json family_to_json(const CompensationModel& model);

/// How often a recording held which pressures: for each pair of segments, the arm's pressure limits
/// in `cells` × `cells` cells, and the frames in each; beyond the limits counts as at them.
Json coverage_to_json(const ArmDescription& arm, const std::vector<Episode>& episodes);

}  // namespace limber
