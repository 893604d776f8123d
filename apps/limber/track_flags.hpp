#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "driver_flags.hpp"
#include "limber/report/track_report.hpp"
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
    return follow_path(with_limits(arm, limits), *motion_, tip_path_, path_, environment, driver,
                       settings_, ExecutionSettings{}, flags.seed);
  }

 private:
  std::string path_;
  int laps_ = 1;
  TipTrackerSettings settings_;
  TipPath tip_path_;
  std::unique_ptr<ForwardModel> forward_;
  std::unique_ptr<MotionModel> motion_;
};

}  // namespace limber
