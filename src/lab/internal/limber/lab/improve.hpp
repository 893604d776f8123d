#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/progress.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/run/collection.hpp"
#include "limber/run/executor.hpp"
#include "limber/training/training_settings.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// The arm that a model is improved on, virtual or real.
struct ImproveArm {
  std::string source;     ///< as recordings have it: "virtual arm"
  std::string about;      ///< everything else that decides the data, in words
  DriverFactory drivers;  ///< for motions as `collect` makes them
  /// Executes a plan from the vented arm, then those that the source gives (null: none), each open
  /// loop from where the last one ended, and vents.
  std::function<ExecutionResult(const Environment&, const Plan&, Controller*)> execute;
  /// Where the vented arm lies now; empty: straight.
  std::function<ArmStart()> start;
  std::vector<PressureLimits> limits;  ///< of plans; empty: the arm's
  double limit_scale = 1.0;            ///< the same for random motions
  bool side_by_side = false;           ///< whether runs on several threads are runs of the same arm
};

/// A fresh virtual arm for every run.
ImproveArm virtual_improve_arm(const ArmDescription& arm);

struct ImproveSettings {
  std::filesystem::path folder = "improved";
  ArmDescription arm;
  std::filesystem::path model_file;               ///< to start from
  std::vector<std::filesystem::path> data_files;  ///< what it has learnt from; replayed
  int rounds = 4;                                 ///< at most, ≥ 1
  double round_min = 10.0;                        ///< arm time to learn from in each round, > 0
  double plan_share = 0.5;  ///< of it, for executed plans; the rest explores; [0, 1]
  int chain = 10;           ///< environments between two ventings, to learn from, ≥ 1
  int selection = 30;       ///< environments that choose the round, ≥ 2
  int reported = 30;        ///< environments and random motions of each round's figures, ≥ 2
  std::uint64_t queries = 20000;  ///< of each plan
  AskedRoom room;                 ///< if nothing is asked for, each model's own error
  /// Each round trains new networks on everything, in the form of the model to start from; else it
  /// goes on from the last round's.
  bool from_start = false;
  /// Each round trains further from this network, on everything; empty: from the last round's.
  std::filesystem::path prior_file;
  /// Of each round: a preset, or `fine_tuning_of` one. Seed, jobs and progress are those below.
  TrainingSettings training;
  std::uint64_t seed = 1;
  int jobs = 0;         ///< threads, 0: one per core; never changes a result
  bool resume = false;  ///< keep what is finished; more rounds may be asked for
  bool force = false;   ///< replace a folder that limber improve did not make
  Progress::Mode progress = Progress::Mode::automatic;
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// @throws InputError naming the setting, what was found and what is allowed.
void require_usable(const ImproveSettings& settings);

/// Refuses before any work: settings out of range, a model or recording that does not fit, a folder
/// that holds something else or another run.
void require_startable(const ImproveSettings& settings);

/// Rounds of planning, executing and learning (docs/improving.md). Writes to the folder
///
///   improve.json               the settings; `resume` asks for the same
///   round_K/exploration.h5     random motions, K from 1
///   round_K/plans.h5, .json    executed plans, and what became of each
///   round_K/model.safetensors  what the round has learnt
///   round_K/selection.h5, .json  plans in the environments that choose the round, K from 0
///   round_K/reported.h5, .json   plans in fresh environments, for the figures
///   round_K/random.h5            random motions, for the figures
///   round_K/round.json         the figures
///   model.safetensors          the best round's model
///   summary.json, report.html, distance.svg
///
/// and returns the summary. No clock limits anything: results depend on settings and arm alone. On
/// a virtual arm a run that was stopped anywhere and resumed gives the same bytes as one that was
/// not.
/// @throws InputError; SystemFault if the arm fails; Interrupted after Ctrl-C. What was executed is
/// on disk then.
nlohmann::ordered_json run_improve(const ImproveSettings& settings, const ImproveArm& on);

}  // namespace limber
