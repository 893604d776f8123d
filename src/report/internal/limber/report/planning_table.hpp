#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/report/report_page.hpp"
#include "limber/run/plan_trial.hpp"

namespace limber {

/// Figures of some numbers; none without numbers. The standard error needs two.
struct SampleFigures {
  int count = 0;
  std::optional<double> mean;
  std::optional<double> median;
  std::optional<double> p95;             ///< quantile(…, 0.95) of common/statistics.hpp
  std::optional<double> standard_error;  ///< of the mean, sample deviation / √count
};

SampleFigures figures_of(const std::vector<double>& values);

/// The number, or `none`.
std::string shown(const std::optional<double>& value, int digits, const char* none = "N/A");

/// One line of the paper's Table I: one environment, one model; and where they are compared, one
/// controller and one disturbance.
struct PlanningRow {
  std::string environment;  ///< EnvironmentCase::id
  std::string model;        ///< "no_load" or "network"
  std::string planner;
  std::string controller = "open";
  std::string disturbance;  ///< empty: none
  int trials = 0;
  int solved = 0;
  int not_certified = 0;              ///< defects: plans that were found and refused
  SampleFigures first_solution_s;     ///< certified
  SampleFigures first_candidate_s;    ///< its two parts: until it was found,
  SampleFigures first_certificate_s;  ///< and its certificate
  SampleFigures first_cost_psi;       ///< of the first plan
  SampleFigures cost_psi;             ///< of the best plan within the limits
  int executed = 0;
  int collided = 0;
  int reached = 0;                 ///< within the goal's tolerances, without collision
  int stopped_ahead = 0;           ///< stopped clear of an obstacle that had appeared
  SampleFigures distance_cm;       ///< executed, runs that collided included
  SampleFigures distance_free_cm;  ///< without them
  SampleFigures orientation_rad;   ///< where the goal asks for a heading
  SampleFigures orientation_free_rad;
  /// As in the paper, one plan per cell: of the first trial that was solved the execution, and what
  /// it is one of; not the plan.
  std::optional<PlanTrial> one_plan;
};

/// Whether the same planner, controller and disturbance made both.
bool is_run_as(const PlanningRow& a, const PlanningRow& b);

/// Stopped because of an obstacle that appeared, without touching anything.
bool is_clean_stop(const ExecutionResult& run);

/// A row for every planner, environment, model, controller and disturbance that has trials, in the
/// order of their first trials.
std::vector<PlanningRow> planning_rows(const std::vector<PlanTrial>& trials);

/// The row of all trials of one model in one environment, or in all of them, whatever planned and
/// executed. @param environment, model  empty: any.
PlanningRow planning_row(const std::vector<PlanTrial>& trials, const std::string& environment,
                         const std::string& model);

/// What the paper found when it compared both models, and whether it was found here too.
struct PaperFinding {
  std::string what;
  std::string paper;
  std::string here;
  std::string verdict;  ///< "reproduced", "not reproduced" or "not comparable"
};

/// Over the environments where the first row's planner planned with both models.
std::vector<PaperFinding> compare_with_paper(const std::vector<PlanningRow>& rows);

/// table.json: a list with one object per row.
Json to_json(const std::vector<PlanningRow>& rows);

/// Table I with all plans executed; Table I with the paper's one plan per cell; times; the
/// comparison.
std::vector<ReportTable> planning_tables(const std::vector<PlanningRow>& rows);

/// The same as Markdown.
std::string tables_to_markdown(const std::string& title, const std::vector<ReportTable>& tables);

}  // namespace limber
