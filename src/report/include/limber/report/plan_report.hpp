#pragma once
// For those who show results.

#include <cstdint>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// The object of `limber plan --json`; missing values are null.
/// @param planner, model  their names; @param seed  that the planner was given
nlohmann::ordered_json to_json(const PlanResult& result, const Command& command,
                               const PoseGoal& goal, const std::string& planner,
                               const std::string& model, std::uint64_t seed);

/// The same in a few lines for people; `command` is what the arm's segments are given.
std::string to_text(const PlanResult& result, const Command& command = {});

/// The object of `limber verify --json`.
nlohmann::ordered_json to_json(const Certificate& certificate, const Command& command,
                               const Environment& environment);
/// The same in a few lines for people.
std::string to_text(const Certificate& certificate, const ArmDescription& arm,
                    const Environment& environment);

}  // namespace limber
