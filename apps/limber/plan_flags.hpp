#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/planning/forest.hpp"
#include "verb.hpp"

namespace limber {

/// The room that plans keep for the model's error, as asked for by flags.
class RoomFlags {
 public:
  /// --margin-m, --goal-margin-m and --goal-margin-rad.
  void add_to(CLI::App& app);

  const AskedRoom& asked() const { return asked_; }
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
};

/// --cost-threshold, and its former name, which help texts leave out. @param target  kept by CLI11
inline void add_cost_threshold(CLI::App& app, std::optional<double>& target) {
  CLI::Option* option =
      app.add_option("--cost-threshold", target,
                     "Stop at a plan this cheap, in the unit of the arm's command (kPa of "
                     "pressures); with a large number, stop at the first plan");
  app.add_option("--cost-threshold-kpa", target)->group("")->excludes(option);
}

}  // namespace limber
