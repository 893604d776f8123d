#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/lab/planning_experiment.hpp"

namespace limber {

/// What a trial belongs to. It is stored in the trial's file; files of other experiments are
/// refused.
struct TrialKey {
  std::string id;           ///< of its files
  std::string experiment;   ///< hash of the experiment's settings
  std::string environment;  ///< EnvironmentCase::id
  std::string environment_hash;
  std::string model;       ///< "no_load" or "network"
  std::string model_hash;  ///< empty for "no_load"
  std::string planner;
  std::string controller = "open";
  std::string disturbance;  ///< empty: none
  std::uint64_t seed = 0;
};

/// Writes the files of a finished trial: plans/ID.json if it was solved, then
/// trials/ID.json, which holds the key and the plan's hash.
void write_trial(OutputFolder& folder, const TrialKey& key, const PlanTrial& trial,
                 const Environment& environment);

/// Whether `write_trial` has finished.
bool has_trial(const fs::path& folder, const std::string& id);

/// Names of its files.
std::vector<std::string> trial_files(const std::string& id);

/// What tables and figures need of a trial: names, status, first solution, plan, and of the
/// execution its status, errors and final shape.
/// @throws InputError naming file and field, and what to do, if the trial is damaged or another
/// experiment's: where its key differs, or its plan is not the one that was written with it,
/// certified, for this arm.
PlanTrial read_trial(const fs::path& folder, const TrialKey& key, const ArmDescription& arm,
                     const Environment& environment);

}  // namespace limber
