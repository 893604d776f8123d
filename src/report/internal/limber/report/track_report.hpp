#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/plan_trial.hpp"
#include "limber/run/track_run.hpp"

namespace limber {

/// Set points that were sent, predicted and measured pressures of each segment over one run, as the
/// text of an SVG file.
std::string execution_pressures_picture(const ArmDescription& arm, const Plan& plan,
                                        const ExecutionResult& result);

/// One run over time, as the text of an SVG file with up to three charts: these pressures; x
/// and y of the tip, predicted and as recorded; clearance from the obstacles, where there are some
/// (of one that appeared, from then on). Predictions end where the plan does.
std::string execution_times_picture(const ArmDescription& arm, const Environment& environment,
                                    const Plan& plan, const ExecutionResult& result);

/// The keys of `plan --json` and `execute --json`, with environment, model and seed before them.
Json planning_to_json(const PlanTrial& trial, const Environment& environment);
/// @pre the trial has been executed.
Json execution_to_json(const PlanTrial& trial, const Environment& environment);

/// Keys of `execute --track --json` (docs/tracking.md).
Json to_json(const TrackRun& run);
std::string to_text(const TrackRun& run);

/// The path wanted, the tip's own, and the distance between them over time, as an SVG file's text.
std::string track_picture(const TrackRun& run);

}  // namespace limber
