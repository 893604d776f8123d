#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "limber/network/compensation_model.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// What an ensemble's networks answer together, as asked for by --ensemble.
class EnsembleFlag {
 public:
  /// --ensemble first|mean.
  void add_to(CLI::App& app);

  bool asks_for_mean() const { return answer_ == "mean"; }
  /// Reads `model_file`; its networks answer as asked, or as its tube has it.
  /// @throws InputError if --ensemble mean is asked of a single network, or of no model.
  CompensationModel read(const std::string& model_file) const;
  /// @throws InputError if the mean is asked for and `model_file` is empty: the no-load model.
  void require_model(const std::string& model_file) const;

 private:
  std::string answer_;  // empty: not asked for
};

/// Reads `model_file`; its networks answer as they did for `plan`.
/// @throws InputError naming both if the plan is of a mean, and the file holds one network.
CompensationModel read_model_of_plan(const std::string& model_file, const Plan& plan,
                                     const std::string& plan_file);

/// What forests of a model have to agree on: the file's content hash, and whether all of its
/// networks answered.
std::string forest_model_hash(const std::string& model_file, const CompensationModel* model);

}  // namespace limber
