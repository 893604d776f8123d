#pragma once
// For those who show results.

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// One arm that moves through an animation, one shape per frame.
struct AnimationTrack {
  std::string label;  ///< "predicted", "executed"
  std::string color;  ///< CSS
  std::vector<Backbone> shapes;
};

/// One self-contained HTML page, which loads nothing else, in which arms move through an
/// environment: play, pause, speed, a slider over time, and set points and pressures of each frame.
/// @param setpoints_kpa  one per frame; may be shorter than the tracks
/// @param pressures_kpa  the same: as predicted, or as measured
std::string animation_page(const ArmDescription& arm, const Environment& environment,
                           const std::string& title, const std::vector<AnimationTrack>& tracks,
                           const std::vector<Pressures>& setpoints_kpa,
                           const std::vector<Pressures>& pressures_kpa);

/// A plan as its model predicts it.
std::string plan_animation(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan);

}  // namespace limber
