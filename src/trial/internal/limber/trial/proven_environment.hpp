#pragma once

#include <cstdint>
#include <optional>

#include "limber/forward/motion_model.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// A random environment (trial/random_environment.hpp) whose goal is proven to be in reach: the
/// motion that it was built around, executed on the virtual arm, reaches it without collision. The
/// nearer `model` is to the arm, the fewer samples are needed. Depends on its arguments alone.
/// @param number  of the environment among those of `seed`
/// @return none if a hundred samples did not give one
std::optional<Environment> sample_proven_environment(const ArmDescription& arm,
                                                     const MotionModel& model, std::uint64_t seed,
                                                     std::uint64_t number);

}  // namespace limber
