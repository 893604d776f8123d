#pragma once

#include <optional>
#include <string>

#include "limber/planning/forest.hpp"
#include "verb.hpp"

namespace limber {

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

}  // namespace limber
