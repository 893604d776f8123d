#pragma once

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

// What pages and scripts get (docs/studio_api.md). Keys are those of limber's files.

/// To 1/parts.
double rounded_to(double value, double parts);

nlohmann::ordered_json arm_to_json(const ArmDescription& arm);

nlohmann::ordered_json obstacle_to_json(const Obstacle& obstacle);
/// The keys of the environment's file.
nlohmann::ordered_json environment_to_json(const Environment& environment);

/// A shape's rows, as they are.
nlohmann::ordered_json exact_backbone(const Backbone& backbone);
/// A shape's 3m numbers, to 0.01 mm and 0.0001 rad: far below a pixel.
nlohmann::ordered_json shape_to_json(const Eigen::Ref<const Backbone>& backbone);
/// To 0.01 mm; null if it is not finite.
nlohmann::ordered_json length_to_json(double length_m);
/// To 0.001 of the unit.
nlohmann::ordered_json pressures_to_json(const Eigen::Ref<const Pressures>& kpa);
/// The same of each frame.
nlohmann::ordered_json rows_to_json(const FrameMatrix& kpa);
nlohmann::ordered_json setpoints_to_json(const Plan& plan);

}  // namespace limber
