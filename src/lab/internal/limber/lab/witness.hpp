#pragma once

#include <functional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/motion_model.hpp"

namespace limber {

/// Shapes (m×3) of an arm that starts at rest, goes straight in pressure to one set points after
/// another, and holds the last ones as a plan does; so close in time that it moves straight from
/// each to the next. The first shape is at rest, the last one at the end of the hold.
using Witness = std::function<std::vector<Backbone>(const std::vector<Pressures>& waypoints_kpa)>;

/// The virtual arm, a shape every hundredth of a second. Borrows the arm.
/// @throws InputError if there is none of this arm: it is not driven by pressures.
Witness virtual_witness(const ArmDescription& arm);

/// An arm that does what a model says, a shape in every frame. Borrows the arm, and what the model
/// borrows.
Witness model_witness(const ArmDescription& arm, const MotionModel& model);

}  // namespace limber
