#pragma once

#include "exact_arm.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

ExactArm::Shape shape_of(const Backbone& backbone);

/// Whether collision is defined: finite poses, and no gap that turns by more than half a turn.
bool is_drawable(const ExactArm::Shape& shape);

/// How far two shapes are apart, and the plate with the largest deviation.
struct Deviation {
  double apart_m = 0.0;
  double turned_rad = 0.0;
  int plate = 0;
};

/// A coordinate that is not a number counts as any distance: comparisons with it are false.
Deviation deviation(const ExactArm::Shape& own, const ExactArm::Shape& stored);

}  // namespace limber
