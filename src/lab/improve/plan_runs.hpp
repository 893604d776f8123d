#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/lab/improve.hpp"
#include "limber/lab/output_folder.hpp"

namespace limber {

/// One environment: planned in, and the plan executed.
struct PlanRun {
  int environment = 0;    ///< its number
  std::string status;     ///< of the planner (PlanStatus)
  bool executed = false;  ///< to its end
  bool collided = false;
  bool arrived = false;  ///< within the goal's tolerances, without collision
  /// Of the end from the goal; none if not executed or untracked.
  std::optional<double> distance_m = std::nullopt;
  double duration_s = 0.0;  ///< of arm time
  bool recorded = false;    ///< in one of `PlanRuns::episodes`
  bool was_vented = false;  ///< the arm, right before it
};

struct PlanRuns {
  std::vector<PlanRun> runs;      ///< by environment
  std::vector<Episode> episodes;  ///< one of each venting that was tracked; its motions are plans
  double arm_time_s = 0.0;

  int ventings() const {
    return static_cast<int>(std::ranges::count_if(runs, &PlanRun::was_vented));
  }
};

/// Which environments, and how many.
struct PlanRunsSettings {
  std::string name;  ///< of its files, in the folder: "round_1/plans"
  std::string what;  ///< for progress: "round 1: plans"
  std::uint64_t seed = 1;
  std::optional<int> environments;  ///< so many …
  double arm_time_s = 0.0;          ///< … or as many as take this long when executed
  int chain = 1;  ///< of them between two ventings: each begins where the plan before ended
};

/// What environments are sampled with, and what plans are made with.
struct PlanRunsModels {
  const MotionModel& sampling;
  const MotionModel& planning;
  std::string planning_hash;
};

/// Plans in random environments and executes the plans. Each chain of them is on disk (NAME.parts)
/// before the next one begins, or on a virtual arm before the next few. Then they are joined:
/// NAME.h5, without which nothing was executed, and NAME.json. What is on disk already is read.
/// @throws InputError if the model solves no environment of many.
PlanRuns run_plans(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                   const PlanRunsModels& models, const PlanRunsSettings& asked);

/// Reads runs that were joined. @throws InputError
PlanRuns read_plan_runs(const OutputFolder& output, const std::string& name);

}  // namespace limber
