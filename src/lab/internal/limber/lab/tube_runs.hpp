#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/common/progress.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/lab/tube_score.hpp"
#include "limber/lab/unseen_arm.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// One random environment: planned in with a tube, executed, and scored against it.
struct TubeRun {
  std::uint64_t number = 0;  ///< of the environment among those of the phase's seed
  std::string status;        ///< PlanStatus, or "no_environment"
  bool executed = false;     ///< to the end of its plan; only these are scored
  double score = 0.0;        ///< (3); 0 where no tube has a shape yet
  double cost_kpa = 0.0;
  double first_solution_s = 0.0;
  double tip_m = 0.0;         ///< largest error of the tip
  double tip_radius_m = 0.0;  ///< of the tube that its plan kept, on average over its frames
  /// Of a family's run: what its adaptation expected the tip to be off by; 0: of no family.
  double expected_error_m = 0.0;
  bool collided = false;
  bool reached = false;  ///< ended in the goal, without collision
  /// Kept where they give a tube its shape; as measured.
  std::optional<GrowingErrors> errors;
};

/// Runs of one phase of a calibration: one plan in each environment, so that they are independent.
struct TubeRuns {
  std::vector<TubeRun> all;  ///< in the order of their environments, up to the last one needed

  int executed() const;
  int solved() const;
  std::vector<double> scores() const;  ///< of executed ones
  /// Runs whose score exceeds the factor.
  int outside(double factor) const;
  /// Of a family's runs, as if each arm were expected to be off by expected_error_m().
  std::vector<GrowingErrors> errors() const;
  /// The median over executed runs; 0: they are of no family.
  double expected_error_m() const;
};

/// What a phase asks for.
struct TubePhase {
  std::string name;  ///< names its files and its environments' seed: no two phases share any
  int runs = 0;      ///< executed runs wanted, ≥ 1
  const Tube* shape = nullptr;  ///< null: plans keep what they keep without a tube
  double factor = 0.0;
  /// Of a family's `shape`: what an arm is expected to be off by whose tube is the shape itself.
  double expected_error_m = 0.0;
  /// Whether it may end with fewer runs where hardly any environment has a plan.
  bool may_fall_short = false;
};

struct TubeRunSettings {
  ArmDescription arm;
  ArmDescription executed_arm;  ///< the same, or with other friction, load or strength
  CompensationModel model;
  ValveParameters valves;
  /// For a family: each run has an arm of its own, to which the model is adapted first; scales of
  /// the tube are then those of an arm of a typical expected error (`Adaptation`).
  std::optional<UnseenArms> unseen;
  PlannerLimits limits;
  std::uint64_t seed = 1;
  int jobs = 0;  ///< runs at once, 0: one per core
  Progress::Mode progress = Progress::Mode::automatic;
};

/// Plans and executes until the phase has its runs. Finished blocks of environments are kept in
/// `folder` and read again; null: nothing is kept. Results depend on neither threads nor stops.
/// @throws InputError if hardly any environment has a plan; Interrupted after a signal, with
/// everything that was finished kept.
TubeRuns run_tube_phase(const TubeRunSettings& settings, const TubePhase& phase,
                        OutputFolder* folder);

/// Figures of a phase: environments, solved, coverage of `factor` with its 95 % interval, cost,
/// first plan, mean radius at the tip, collisions, arrivals.
Json to_json(const TubeRuns& runs, double factor);

}  // namespace limber
