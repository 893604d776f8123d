#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/report/planning_table.hpp"
#include "limber/report/report_page.hpp"
#include "limber/report/run_table.hpp"

namespace limber {

/// What has to be the same for trials of two runs to be in one table. The number of trials may
/// differ: more can be added.
Json experiment_identity(const ExperimentSettings& settings, const std::string& model_hash);

/// @throws InputError naming the first key of `file` in which it differs from `wanted`.
void require_same_experiment(const fs::path& file, nlohmann::json wanted);

/// Names of what is written of one environment, relative to the experiment's folder. Of more than
/// 400 they lie in numbered folders: shared file systems suffer from thousands of entries in one.
struct ResultNames {
  std::string one_plan;  ///< a figure
  std::string all_plans;
  std::string log;
};
ResultNames result_names(const ExperimentSettings& settings, const EnvironmentCase& item);

/// Tables, figures and logs of an experiment, written as its environments come in: what is kept of
/// a trial are some numbers, so that thousands can be joined.
class ExperimentResults {
 public:
  /// Both are borrowed.
  ExperimentResults(const ExperimentSettings& settings, OutputFolder& output)
      : settings_(settings), output_(output) {}

  /// All trials of one of the settings' environments: writes its figures and its log.
  void add(const EnvironmentCase& item, const std::vector<PlanTrial>& trials);

  /// Writes the tables and the report. @returns table.json
  Json write();

 private:
  void write_report(const std::string& title, const std::vector<ReportTable>& tables);

  const ExperimentSettings& settings_;
  OutputFolder& output_;
  std::vector<PlanningRow> rows_;
  RunCount runs_;
  std::vector<ReportFigure> figures_;  ///< two of each of the first environments
};

}  // namespace limber
