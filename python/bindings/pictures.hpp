#pragma once

#include <optional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber::python {

// What `_repr_svg_` shows in a notebook: the text of an SVG file.

/// The arm at rest.
std::optional<std::string> arm_picture(const ArmDescription& arm);
std::string backbone_picture(const ArmDescription& arm, const Backbone& backbone);
/// Obstacles and goal; nothing is known of the arm.
std::string obstacles_picture(const Environment& environment);
/// The arm along a plan; it is the arm that the plan holds. Empty where the plan holds none.
std::string motion_picture(const Plan& plan);
/// Mean tip errors by how often a prediction is corrected.
std::string evaluation_picture(const Evaluation& evaluation);

}  // namespace limber::python
