#pragma once
// For those who compare planners and models over many trials.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/progress.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/run/plan_trial.hpp"
#include "limber/world/environment.hpp"

namespace limber {

struct ExperimentSettings {
  std::filesystem::path folder = "experiment";
  ArmDescription arm;
  std::filesystem::path model_file;  ///< network; the no-load model is always the other one
  /// Valves in every prediction, whatever its model; with ideal ones, pressures are the set points.
  ValveParameters valves;
  std::vector<EnvironmentCase> environments;
  /// Folders of finished experiments that differ in their environment alone, one for each of
  /// `environments`: their trials are read, and none is run. Empty: all are run here.
  std::vector<std::filesystem::path> parts;
  int trials = 20;  ///< of each environment and model, ≥ 1; trial k has the same seed everywhere
  std::vector<std::string> planners = {"default"};
  bool with_no_load = true;  ///< false: the network alone, to compare planners
  /// Forest for the network, grown from the start of every environment; used by the default
  /// planner's trials with the network. None: everything is searched.
  std::optional<Forest> forest;
  PlannerLimits limits;
  /// How plans are executed, and what the arm then meets: rows of their own for each of both.
  std::vector<std::string> controllers = {"open"};
  std::vector<std::string> disturbances = {""};
  std::uint64_t motion_queries =
      0;               ///< of controller "replan": of a search in mid-motion, 0: none then
  bool adapts = true;  ///< … follows which arm of its family this is
  AskedRoom room;      ///< if nothing is asked for, each model's own error
  std::uint64_t seed = 1;
  int planner_jobs = 1;  ///< threads of each planner
  int jobs = 0;          ///< trials at once, 0: one per core
  bool resume = false;   ///< keep finished trials of the same experiment
  bool force = false;    ///< replace a folder that limber experiment did not make
  Progress::Mode progress = Progress::Mode::automatic;
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// Refuses what can be refused before any work: planners, folder, number of trials.
/// @throws InputError
void require_usable(const ExperimentSettings& settings);

/// `motion_queries` of the experiment that is to be resumed; none if it says nothing, or is new.
std::optional<std::uint64_t> known_motion_queries(const ExperimentSettings& settings);

/// The paper's Table I on the virtual arm: every environment planned in with both models, every
/// plan certified, and the same one executed by every controller under every disturbance; what is
/// left of a plan's trials when `resume` goes on has it searched again. Writes to the folder
///
///   experiment.json         the settings; `resume` asks for the same
///   trials/ID.json          keys of `plan --json`, and of `execute --json` under "execution"
///   plans/ID.json           the plans
///   figures/ENVIRONMENT.svg the paper's Fig. 5: one final shape of each model; …_all.svg: all
///   table.json, table.md    planning_table.hpp
///   runs.json               run_table.hpp: arrivals, collisions and stops over all environments
///   report.html             tables and figures on one page
///   planner_arena/*.log     OMPL's benchmark logs, one for each environment
///                           (of over 400 environments these and figures in folders 000 …)
///
/// and returns the table. Trials are spread over threads; if no clock limits them, results do not
/// depend on `jobs`. The table is read from the files, whether they are new or resumed.
/// @throws InputError if settings are out of range, or differ from those being resumed;
/// Interrupted after Ctrl-C: finished trials are kept.
nlohmann::ordered_json run_experiment(const ExperimentSettings& settings);

/// Every *.yaml of a folder, sorted by name; or one such file.
/// @throws InputError naming the folder where it is none or has no such file, or the file that
///   can't be read or has a name that is not UTF-8.
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
  bool adapts = true;                  ///< … follows which arm of its family this is
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
