#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// How often a recording held which pressures: for each pair of segments, the arm's pressure limits
/// in `cells` × `cells` cells, and the frames in each; beyond the limits counts as at them.
Json coverage_to_json(const ArmDescription& arm, const std::vector<Episode>& episodes);

}  // namespace limber
