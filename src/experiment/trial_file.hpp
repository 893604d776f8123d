#pragma once

#include <filesystem>
#include <string>

#include "limber/experiment/plan_trial.hpp"

namespace limber {

/// Writes what a finished trial left behind: FOLDER/plans/ID.json where it was solved, then
/// FOLDER/trials/ID.json.
void write_trial(const std::filesystem::path& folder, const std::string& id, const PlanTrial& trial,
                 const Environment& environment);

/// Whether `write_trial` has come to its end.
bool has_trial(const std::filesystem::path& folder, const std::string& id);

/// What tables and figures need of a trial: names, status, first solution, plan, and of the
/// execution its status, errors and final shape. @throws InputError naming the file.
PlanTrial read_trial(const std::filesystem::path& folder, const std::string& id,
                     const Environment& environment);

}  // namespace limber
