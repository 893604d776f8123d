#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "driver_flags.hpp"
#include "limber/report/track_report.hpp"
#include "limber/run/tip_tracker.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "model_flags.hpp"

namespace limber {

/// `limber execute --track`: a path of the tip over time in place of a plan.
class TrackFlags {
 public:
  /// --track, --laps and --track-queries.
  void add_to(CLI::App& app);

  bool is_asked() const { return !path_.empty(); }

  /// Reads the path and the model.
  /// @throws InputError naming file and line where path and arm do not fit.
  void prepare(const ArmDescription& arm, const ModelFlags& model, const CommonFlags& flags);

  /// Looks for set points that bring the tip to the path's start, and follows it from there.
  /// @pre prepared. @param limits  narrower than the arm's; empty: the arm's
  /// @throws InputError naming file and line of a start that the tip does not come to.
  template <class Driver>
  TrackRun run(const ArmDescription& arm, const Environment& environment, Driver& driver,
               const std::vector<PressureLimits>& limits, const CommonFlags& flags) {
    const ArmDescription narrow = with_limits(arm, limits);
    TipTracker tracker(narrow, *motion_, tip_path_, start_on(narrow, flags), settings_, flags.seed);
    ExecutionSettings execution;
    execution.controller = &tracker;
    TrackRun run;
    run.path = tip_path_;
    run.result = execute(arm, environment, stay_at_rest(arm, environment), driver, execution);
    run.start_frame = tracker.path_start_frame();
    run.queries = tracker.queries();
    run.errors =
        track_errors(tip_path_, run.result.episode, run.start_frame + run.result.lag_frames);
    if (run.result.status == ExecutionStatus::done) {
      run.result.message = why_not_followed(run.result);  // there is no goal to miss
    }
    return run;
  }

 private:
  /// Empty if it was seen to its end, and struck nothing.
  static std::string why_not_followed(const ExecutionResult& result);
  /// A plan of one frame: the controller decides all others.
  static Plan stay_at_rest(const ArmDescription& arm, const Environment& environment);
  TrackStart start_on(const ArmDescription& arm, const CommonFlags& flags) const;

  std::string path_;
  int laps_ = 1;
  TipTrackerSettings settings_;
  TipPath tip_path_;
  std::unique_ptr<ForwardModel> forward_;
  std::unique_ptr<MotionModel> motion_;
};

}  // namespace limber
