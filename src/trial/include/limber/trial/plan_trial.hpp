#pragma once
// For those who compare planners and models over many trials.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/hardware/executor.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// An environment and its short name in files and tables, "03_gap_in_a_wall".
struct EnvironmentCase {
  std::string id;
  Environment environment;
};

/// Every *.yaml of a folder, sorted by name.
/// @throws InputError naming the folder where it is none or has no such file, or the file that
///   can't be read.
std::vector<EnvironmentCase> environments_in(const std::filesystem::path& folder,
                                             const ArmDescription& arm);

/// One plan and its outcome on the virtual arm.
struct PlanTrial {
  std::string environment;  ///< EnvironmentCase::id
  std::string model;        ///< "no_load" or "network"
  std::string planner;
  std::string controller = "open";  ///< that executed the plan
  std::string disturbance;          ///< "friction", "tip_load=0.1,noise"; empty: none
  std::uint64_t seed = 0;
  bool asks_heading = false;  ///< whether the goal does
  PlanResult planning;
  std::optional<ExecutionResult> execution;  ///< none without a plan

  bool solved() const { return planning.status == PlanStatus::solved; }
};

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

/// Plans again from where the arm is measured, while it moves and after (docs/planning.md, Closed
/// loop): for ExecutionSettings::replanner. A search takes 2000 queries while the arm moves, 20 000
/// when it stands. Without tracking the run is open loop. Borrows arm, environment and what the
/// model borrows. Threads: one run at a time.
std::unique_ptr<PlanSource> make_replanner(const ArmDescription& arm, const MotionModel& model,
                                           const Environment& environment, const ErrorRoom& room,
                                           std::uint64_t seed);

/// Means over the trials of one model in one environment, or in all of them; none where nothing
/// counts.
struct TrialSummary {
  int trials = 0;
  int solved = 0;
  int executed = 0;  ///< to their end
  int collided = 0;
  int reached = 0;  ///< ended within the goal's tolerances, without collision
  std::optional<double> first_solution_s;     ///< over solved trials, certified
  std::optional<double> first_candidate_s;    ///< its two parts: until it was found,
  std::optional<double> first_certificate_s;  ///< and its certificate
  std::optional<double> cost_kpa;             ///< over solved trials
  std::optional<double> distance_m;           ///< executed, including runs that collided
  std::optional<double> distance_free_m;      ///< executed without collision
  std::optional<double> orientation_rad;      ///< executed, where the goal asks for a heading
};
/// @param environment, model  empty: any.
TrialSummary summarise(const std::vector<PlanTrial>& trials, const std::string& environment,
                       const std::string& model);

/// The cheapest solved trial; null if there is none. @param environment, model  empty: any.
const PlanTrial* cheapest_plan(const std::vector<PlanTrial>& trials, const std::string& environment,
                               const std::string& model);

}  // namespace limber
