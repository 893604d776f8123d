#pragma once

#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/run/closed_loop.hpp"
#include "verb.hpp"

namespace limber {

/// --plans-out: the plans after the first that a closed loop followed, and what each was certified
/// for.
class FurtherPlans {
 public:
  void add_to(CLI::App& app);
  bool are_asked_for() const { return !out_.empty(); }

  /// Clears the folder before the run: what lies in it is never of an earlier one.
  /// @param inputs  files of the run, which are not to lie in it
  void prepare(const std::vector<fs::path>& inputs, const CommonFlags& flags);
  /// Does nothing where they are not asked for.
  void take(const ClosedLoop& loop);
  void write(const std::string& model_file);

 private:
  std::string out_;
  std::optional<OutputFolder> folder_;
  std::list<FollowedPlan> plans_;
};

}  // namespace limber
