#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/world/environment.hpp"

namespace limber {

inline constexpr double kPictureWidthPx = 640.0;  // of what is drawn to scale

/// The page that the studio saves for a colleague (web/src/animation.ts): it holds the motion and
/// loads nothing else.
/// @param motion  frame_rate_hz, setpoints_kpa, appeared and tracks, as the studio's page gets them
/// @param still   SVG that stands in it where scripts are off
std::string animation_page(const ArmDescription& arm, const Environment& environment,
                           const std::string& title, nlohmann::ordered_json motion,
                           const std::string& still);

}  // namespace limber
