#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "driver_flags.hpp"
#include "limber/report/track_report.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "model_flags.hpp"
#include "verb.hpp"

namespace limber {

/// --replan, and how a plan is then replaced while it is executed.
class ReplanFlags {
 public:
  void add_to(CLI::App& app);
  /// Of these flags --motion-queries and --no-adapt alone, for verbs that are told in other ways to
  /// replan.
  void add_settings_to(CLI::App& app);

  bool is_asked_for() const { return replan_; }
  ClosedLoopSettings& settings() { return settings_; }
  const ClosedLoopSettings& settings() const { return settings_; }

  /// Sets the queries of a search in mid-motion, where no flag says how many: as many as fit into
  /// part of a frame on this machine. Says so.
  /// @param known  of earlier runs that these continue
  void choose_motion_queries(const ArmDescription& arm, const MotionModel& model,
                             std::optional<std::uint64_t> known, const CommonFlags& flags);

 private:
  bool replan_ = false;
  std::optional<std::uint64_t> motion_queries_;
  ClosedLoopSettings settings_;
};

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
