#pragma once

#include "default_planner.hpp"
#include "planner_name.hpp"

namespace limber {

/// @throws InputError naming the setting that is out of range, and its range.
void require_valid(const DefaultPlannerSettings& settings);

/// The settings behind a planner's name, the others by default.
/// @throws InputError if one is unknown or out of range.
DefaultPlannerSettings default_settings_of(PlannerName name);

}  // namespace limber
