#pragma once
// For those who compare planners and models over many trials.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/run/plan_trial.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// Every *.yaml of a folder, sorted by name.
/// @throws InputError naming the folder where it is none or has no such file, or the file that
///   can't be read.
std::vector<EnvironmentCase> environments_in(const std::filesystem::path& folder,
                                             const ArmDescription& arm);

struct PlanTrialSettings {
  std::string planner = "default";
  int planner_jobs = 1;  ///< threads of the planner; trials themselves run side by side
  PlannerLimits limits;
  std::vector<PressureLimits> within;  ///< PlanningProblem::limits
  AskedRoom room;                      ///< if nothing is asked for, the model's own error
  const Forest* forest = nullptr;      ///< for the default planner; borrowed
  std::uint64_t motion_queries = 0;    ///< in closed loop: of a search in mid-motion, 0: none then
  std::string model_hash;              ///< goes into the plan of a network; docs/formats.md
  /// How plans are executed, and what the arm then meets (docs/experiments.md).
  std::string controller = "open";
  std::string disturbance;
};

/// Plans in the environment with `model`, until its limits or Ctrl-C. The result's execution is not
/// set.
PlanTrial plan_trial(const ArmDescription& arm, const MotionModel& model,
                     const EnvironmentCase& item, const PlanTrialSettings& settings,
                     std::uint64_t seed);

/// Executes the trial's plan, if it has one, on a fresh virtual arm at rest without sensor faults.
void execute_trial(const ArmDescription& arm, const Environment& environment, PlanTrial& trial);

}  // namespace limber
