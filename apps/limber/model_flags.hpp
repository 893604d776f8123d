#pragma once

#include <string>

#include "limber/arm/valve_parameters.hpp"
#include "limber/forward/motion_model.hpp"
#include "verb.hpp"

namespace limber {

/// What motions are predicted with, as named by flags: a network or the no-load model, and valves.
class ModelFlags {
 public:
  /// --model, --no-load, --valves and --no-valves. @param of_plan  "… that it was made with"
  void add_to(CLI::App& app, const std::string& of_plan);
  /// --valves and --no-valves alone, for verbs that ask for a model in their own way.
  void add_valves_to(CLI::App& app);

  bool names_model() const { return !model_.empty(); }
  bool asks_no_load() const { return no_load_; }
  /// Whether --valves or --no-valves is given.
  bool says_valves() const { return !valves_.empty() || no_valves_; }
  const std::string& model_file() const { return model_; }

  /// @throws InputError if neither --model nor --no-load is given, or if a file does not fit.
  /// For searching motions with: a network needs bounds (require_bounded).
  ForwardModel planning_model(const ArmDescription& arm) const;

  /// Those of --valves FILE, else those that `network` was trained with; none with --no-valves, and
  /// none before a network that learnt from set points.
  /// @param network  null: the no-load model
  /// @throws InputError if they do not fit the arm, or if --valves FILE names some for a network
  /// that learnt from set points.
  ValveParameters valves(const ArmDescription& arm, const CompensationModel* network) const;
  MotionModel motion_model(const ArmDescription& arm, const ForwardModel& forward) const;
  /// Warns if no valve model is known, one is needed and --no-valves was not given.
  void warn_without_valves(const MotionModel& model, const CommonFlags& flags) const;

 private:
  std::string model_;
  bool no_load_ = false;
  std::string valves_;
  bool no_valves_ = false;
};

}  // namespace limber
