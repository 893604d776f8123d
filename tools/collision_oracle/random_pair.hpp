#pragma once

#include "limber/arm/no_load_model.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// A motion of one frame, or several at once, and an obstacle: one time in four anywhere, else
/// moved until it is within ± 3 mm of touching, where checks may go wrong.
struct RandomPair {
  Backbone from;
  Backbone to;
  Obstacle obstacle;
};

RandomPair random_pair(const ArmDescription& arm, const NoLoadModel& model, RandomStream& random);

}  // namespace limber
