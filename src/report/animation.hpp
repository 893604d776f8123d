#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

inline constexpr double kPictureWidthPx = 640.0;  // of what is drawn to scale

/// "34.1 psi"; in the unit of the arm's command, where that is no pressure.
std::string cost_text(const Plan& plan);

/// web/src/packing.ts: each number's change since the frame before, in whole units, in base 64.
/// @param frames  a list of numbers each  @param units  of the columns, over and over
std::string packed_frames(const Json& frames, const std::vector<double>& units);

/// A page that holds its data and script, and loads nothing else.
/// @param script  file of web/dist  @param items  HTML of the list beside the picture
std::string scripted_page(const std::string& script, const std::string& title,
                          const std::string& still, const std::string& items, const Json& data);

/// The page that the studio saves for a colleague (web/src/animation.ts): it holds the motion and
/// loads nothing else.
/// @param motion  frame_rate_hz, setpoints_kpa, appeared and tracks, as the studio's page gets them
/// @param still   SVG that stands in it where scripts are off
std::string animation_page(const ArmDescription& arm, const Environment& environment,
                           const std::string& title, Json motion, const std::string& still);

}  // namespace limber
