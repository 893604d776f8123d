#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limber/run/plan_trial.hpp"

namespace limber {

/// The keys of `plan --json` and `execute --json`, with environment, model and seed before them.
nlohmann::ordered_json planning_to_json(const PlanTrial& trial, const Environment& environment);
/// @pre the trial has been executed.
nlohmann::ordered_json execution_to_json(const PlanTrial& trial, const Environment& environment);

}  // namespace limber
