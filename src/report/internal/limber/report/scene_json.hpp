#pragma once

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

// What pages and scripts get (docs/studio_api.md). Keys are those of limber's files.

/// To 1/parts.
double rounded_to(double value, double parts);

Json arm_to_json(const ArmDescription& arm);

Json obstacle_to_json(const Obstacle& obstacle);
/// The keys of the environment's file.
Json environment_to_json(const Environment& environment);

/// A shape's rows, as they are.
Json exact_backbone(const Backbone& backbone);
/// A shape's 3m numbers, to 0.01 mm and 0.0001 rad: far below a pixel.
Json shape_to_json(const Eigen::Ref<const Backbone>& backbone);
/// To 0.01 mm; null if it is not finite.
Json length_to_json(double length_m);
/// To 0.001 of the unit.
Json pressures_to_json(const Eigen::Ref<const Pressures>& kpa);
/// The same of each frame.
Json rows_to_json(const FrameMatrix& kpa);
Json setpoints_to_json(const Plan& plan);

}  // namespace limber
