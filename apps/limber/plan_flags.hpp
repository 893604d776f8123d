#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "driver_flags.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/planning/forest.hpp"
#include "limber/report/track_report.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "model_flags.hpp"
#include "verb.hpp"

namespace limber {

/// The room that plans keep for the model's error, as asked for by flags.
class RoomFlags {
 public:
  /// --margin-m, --goal-margin-m and --goal-margin-rad.
  void add_to(CLI::App& app);

  const AskedRoom& asked() const { return asked_; }
  /// @throws InputError where --goal-margin-rad is for a goal without heading.
  void require_use(const Environment& environment) const;
  /// The amounts asked for; the model's own where no flag asks. Says on standard error if those are
  /// not measured.
  ErrorRoom room(const ForwardModel& model, const CommonFlags& flags) const;

 private:
  AskedRoom asked_;
};

/// --limit, --rate-limit: what to plan within, narrower than the arm's limits.
class LimitFlags {
 public:
  void add_to(CLI::App& app);

  /// One of each segment; empty where the flag was not given. @throws InputError if a value is no
  /// range, names no segment, or goes beyond the arm's limits.
  std::vector<PressureLimits> limits(const ArmDescription& arm) const;
  /// None where the flag was not given.
  std::optional<double> rate_limit() const { return rate_limit_; }

 private:
  std::vector<std::string> values_;
  std::optional<double> rate_limit_;
};

/// --forest, --build-forest and --forest-nodes, for verbs that plan.
class ForestFlags {
 public:
  void add_to(CLI::App& app);

  bool is_asked_for() const { return !file_.empty() || build_; }
  /// @throws InputError where --forest-nodes comes alone.
  void require_use() const;
  bool builds() const { return build_; }

  /// The forest of --forest. It is grown and stored if there is none, if it is of another arm,
  /// model or start, and with --build-forest.
  /// @param model_file  empty for the no-load model
  /// @return none if Ctrl-C interrupted the growth
  std::optional<Forest> forest(const ArmDescription& arm, const MotionModel& model,
                               const std::string& model_file, const ArmStart& start,
                               const CommonFlags& flags) const;

 private:
  std::string path_beside(const std::string& model_file) const;

  std::string file_;
  bool build_ = false;
  int nodes_ = ForestSettings().nodes;
  const CLI::Option* nodes_flag_ = nullptr;
};

/// --cost-threshold, also by its name for arms that pressures drive. @param target  kept by CLI11
inline void add_cost_threshold(CLI::App& app, std::optional<double>& target) {
  app.add_option("--cost-threshold,--cost-threshold-kpa", target,
                 "Stop at a plan this cheap, in the unit of the arm's command (kPa of pressures); "
                 "with a large number, stop at the first plan")
      ->check(more_than_zero());
}

/// --replan, and how a plan is then replaced while it is executed.
class ReplanFlags {
 public:
  void add_to(CLI::App& app);
  /// Of these flags --motion-queries and --no-adapt alone, for verbs that are told in other ways to
  /// replan.
  void add_settings_to(CLI::App& app);

  bool is_asked_for() const { return replan_; }
  /// Whether --motion-queries, --adapt or --no-adapt is given.
  bool has_settings() const { return motion_queries_ || adapt_flag_->count() > 0; }
  /// Whether --adapt is given.
  bool says_adapt() const { return adapt_flag_->count() > 0 && settings_.adapts; }
  ClosedLoopSettings& settings() { return settings_; }
  const ClosedLoopSettings& settings() const { return settings_; }

  /// Sets the queries of a search in mid-motion, where no flag says how many: as many as fit into
  /// part of a frame on this machine. Says so.
  /// @param known  of earlier runs that these continue
  void choose_motion_queries(const ArmDescription& arm, const MotionModel& model,
                             std::optional<std::uint64_t> known, const CommonFlags& flags);

 private:
  bool replan_ = false;
  const CLI::Option* adapt_flag_ = nullptr;
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
