#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/plan_spread.hpp"

namespace limber {

/// The object `spread` of `plan --json` and `verify --json`.
Json to_json(const PlanSpread& spread);

/// "the 5 networks of this model, each by itself, put the end 0.4 to 1.3 cm from the goal …".
/// @param whose  "this model", or a file
std::string to_text(const PlanSpread& spread, const std::string& whose, const ArmDescription& arm,
                    const Environment& environment);

}  // namespace limber
