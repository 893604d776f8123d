#include "limber/report/planning_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

/// The numbers behind a row.
struct Samples {
  std::vector<double> first_solution_s, first_candidate_s, first_certificate_s;
  std::vector<double> first_cost_psi, cost_psi;
  std::vector<double> distance_cm, distance_free_cm, orientation_rad, orientation_free_rad;
};

void add_execution(const PlanTrial& trial, PlanningRow& row, Samples& samples) {
  if (!trial.execution || !has_run(*trial.execution)) {
    return;
  }
  const ExecutionResult& run = *trial.execution;
  ++row.executed;
  row.collided += run.collided ? 1 : 0;
  row.reached += has_arrived(run) ? 1 : 0;
  row.stopped_ahead += is_clean_stop(run) ? 1 : 0;
  if (!run.final_backbone) {
    return;
  }
  samples.distance_cm.push_back(run.goal_error.position_m * kCmPerM);
  if (!run.collided) {
    samples.distance_free_cm.push_back(run.goal_error.position_m * kCmPerM);
  }
  if (trial.asks_heading) {
    samples.orientation_rad.push_back(run.goal_error.orientation_rad);
    if (!run.collided) {
      samples.orientation_free_rad.push_back(run.goal_error.orientation_rad);
    }
  }
}

bool is_of(const PlanTrial& trial, const PlanningRow& row) {
  return trial.environment == row.environment && trial.model == row.model &&
         trial.planner == row.planner && trial.controller == row.controller &&
         trial.disturbance == row.disturbance;
}

/// What tables and figures show of it.
PlanTrial run_of(const PlanTrial& trial) {
  PlanTrial run;
  run.environment = trial.environment;
  run.model = trial.model;
  run.asks_heading = trial.asks_heading;
  run.execution = trial.execution;
  return run;
}

template <class IsCounted>
void fill(PlanningRow& row, const std::vector<PlanTrial>& trials, const IsCounted& is_counted) {
  Samples samples;
  for (const PlanTrial& trial : trials) {
    if (!is_counted(trial)) {
      continue;
    }
    ++row.trials;
    row.not_certified += trial.planning.status == PlanStatus::not_certified ? 1 : 0;
    if (!trial.solved()) {
      continue;
    }
    ++row.solved;
    if (!row.one_plan) {
      row.one_plan = run_of(trial);
    }
    const FirstSolution& first = *trial.planning.first_solution;
    samples.first_solution_s.push_back(first.time_s);
    samples.first_candidate_s.push_back(first.candidate_s);
    samples.first_certificate_s.push_back(first.certificate_s);
    samples.first_cost_psi.push_back(first.cost_kpa / kKpaPerPsi);
    samples.cost_psi.push_back(trial.planning.plan->cost_kpa / kKpaPerPsi);
    add_execution(trial, row, samples);
  }
  row.first_solution_s = figures_of(samples.first_solution_s);
  row.first_candidate_s = figures_of(samples.first_candidate_s);
  row.first_certificate_s = figures_of(samples.first_certificate_s);
  row.first_cost_psi = figures_of(samples.first_cost_psi);
  row.cost_psi = figures_of(samples.cost_psi);
  row.distance_cm = figures_of(samples.distance_cm);
  row.distance_free_cm = figures_of(samples.distance_free_cm);
  row.orientation_rad = figures_of(samples.orientation_rad);
  row.orientation_free_rad = figures_of(samples.orientation_free_rad);
}

Json to_json(const SampleFigures& figures) {
  return {{"mean", json_number(figures.mean)},
          {"median", json_number(figures.median)},
          {"p95", json_number(figures.p95)},
          {"standard_error", json_number(figures.standard_error)},
          {"count", figures.count}};
}

/// The model; planner, controller and disturbance if they are not the usual ones.
std::string model_name(const PlanningRow& row) {
  const std::string model = row.model == "network" ? "Network" : "No load";
  std::string name = row.planner == "default" ? model : model + ", " + row.planner;
  name += row.controller == "open" ? "" : ", " + row.controller;
  return row.disturbance.empty() ? name : name + ", " + row.disturbance;
}

std::string with_error(const SampleFigures& figures, int digits) {
  return figures.standard_error ? fmt::format("{:.{}f} ± {:.{}f}", *figures.mean, digits,
                                              *figures.standard_error, digits)
                                : shown(figures.mean, digits);
}

ReportTable all_plans_table(const std::vector<PlanningRow>& rows) {
  ReportTable table{
      "Table I, every plan executed. Mean ± standard error; distance and orientation with / "
      "without runs that collided",
      {"Environment", "Model", "Solved", "Reached", "Collided", "Distance to goal (cm)",
       "Orientation to goal (rad)", "First certified plan (s)", "Cost (psi)"}};
  for (const PlanningRow& row : rows) {
    table.rows.push_back(
        {row.environment, model_name(row), fmt::format("{} of {}", row.solved, row.trials),
         fmt::format("{} of {}", row.reached, row.executed),
         fmt::format("{} of {}", row.collided, row.executed),
         shown(row.distance_cm.mean, 1) + " / " + shown(row.distance_free_cm.mean, 1),
         shown(row.orientation_rad.mean, 2) + " / " + shown(row.orientation_free_rad.mean, 2),
         with_error(row.first_solution_s, 4), with_error(row.cost_psi, 1)});
  }
  return table;
}

ReportTable one_plan_table(const std::vector<PlanningRow>& rows) {
  ReportTable table{
      "Table I as in the paper: one plan per cell (of the first trial solved) executed; N/A if it "
      "collided",
      {"Environment", "Model", "Successful plans", "Plan time (s)", "Plan cost (psi)", "Collision",
       "Distance to goal (cm)", "Orientation to goal (rad)"}};
  for (const PlanningRow& row : rows) {
    std::vector<std::string> cells = {row.environment, model_name(row), std::to_string(row.solved),
                                      with_error(row.first_solution_s, 4),
                                      with_error(row.cost_psi, 1)};
    const std::optional<PlanTrial>& trial = row.one_plan;
    const bool ran = trial && trial->execution && has_run(*trial->execution);
    const bool struck = ran && trial->execution->collided;
    const bool free = ran && !struck && trial->execution->final_backbone;
    cells.push_back(struck ? "Yes" : free ? "No" : "N/A");
    cells.push_back(free ? fmt::format("{:.2f}", trial->execution->goal_error.position_m * kCmPerM)
                         : "N/A");
    cells.push_back(free && trial->asks_heading
                        ? fmt::format("{:.2f}", trial->execution->goal_error.orientation_rad)
                        : "N/A");
    table.rows.push_back(std::move(cells));
  }
  return table;
}

ReportTable spread_table(const std::vector<PlanningRow>& rows) {
  ReportTable table{"Medians and 95th percentiles; a defect is a plan refused by its certificate",
                    {"Environment", "Model", "First certified plan, median (s)", "95 % (s)",
                     "Its candidate, certificate (s)", "First plan's cost (psi)",
                     "Distance, median (cm)", "95 % (cm)", "Defects"}};
  for (const PlanningRow& row : rows) {
    table.rows.push_back(
        {row.environment, model_name(row), shown(row.first_solution_s.median, 4),
         shown(row.first_solution_s.p95, 4),
         shown(row.first_candidate_s.median, 4) + ", " + shown(row.first_certificate_s.median, 4),
         with_error(row.first_cost_psi, 1), shown(row.distance_cm.median, 1),
         shown(row.distance_cm.p95, 1), std::to_string(row.not_certified)});
  }
  return table;
}

ReportTable findings_table(const std::vector<PlanningRow>& rows) {
  ReportTable table{"What the paper found about its two models, and what was found here",
                    {"Network plans against no-load plans", "The paper", "Here", "Verdict"}};
  for (const PaperFinding& finding : compare_with_paper(rows)) {
    table.rows.push_back({finding.what, finding.paper, finding.here, finding.verdict});
  }
  return table;
}

}  // namespace

SampleFigures figures_of(const std::vector<double>& values) {
  SampleFigures figures;
  figures.count = int(values.size());
  if (values.empty()) {
    return figures;
  }
  figures.mean = mean(values);
  figures.median = median(values);
  figures.p95 = quantile(values, 0.95);
  if (values.size() >= 2) {
    figures.standard_error = standard_error(values);
  }
  return figures;
}

std::string shown(const std::optional<double>& value, int digits, const char* none) {
  return value ? fmt::format("{:.{}f}", *value, digits) : none;
}

std::vector<PlanningRow> planning_rows(const std::vector<PlanTrial>& trials) {
  std::vector<PlanningRow> rows;
  for (const PlanTrial& trial : trials) {
    if (std::ranges::none_of(rows, [&](const PlanningRow& row) { return is_of(trial, row); })) {
      PlanningRow row;
      row.environment = trial.environment;
      row.model = trial.model;
      row.planner = trial.planner;
      row.controller = trial.controller;
      row.disturbance = trial.disturbance;
      fill(row, trials, [&](const PlanTrial& other) { return is_of(other, row); });
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

PlanningRow planning_row(const std::vector<PlanTrial>& trials, const std::string& environment,
                         const std::string& model) {
  PlanningRow row;
  row.environment = environment;
  row.model = model;
  fill(row, trials, [&](const PlanTrial& trial) {
    return (environment.empty() || trial.environment == environment) &&
           (model.empty() || trial.model == model);
  });
  return row;
}

Json to_json(const std::vector<PlanningRow>& rows) {
  return mapped<Json>(rows, [&](const PlanningRow& row) {
    return Json{{"environment", row.environment},
                {"model", row.model},
                {"planner", row.planner},
                {"controller", row.controller},
                {"disturbance", row.disturbance},
                {"trials", row.trials},
                {"solved", row.solved},
                {"not_certified", row.not_certified},
                {"first_solution_s", to_json(row.first_solution_s)},
                {"first_candidate_s", to_json(row.first_candidate_s)},
                {"first_certificate_s", to_json(row.first_certificate_s)},
                {"first_solution_cost_psi", to_json(row.first_cost_psi)},
                {"cost_psi", to_json(row.cost_psi)},
                {"executed", row.executed},
                {"collided", row.collided},
                {"reached", row.reached},
                {"stopped_ahead", row.stopped_ahead},
                {"distance_to_goal_cm", to_json(row.distance_cm)},
                {"distance_to_goal_without_collision_cm", to_json(row.distance_free_cm)},
                {"orientation_to_goal_rad", to_json(row.orientation_rad)},
                {"orientation_to_goal_without_collision_rad", to_json(row.orientation_free_rad)}};
  });
}

bool is_clean_stop(const ExecutionResult& run) {
  return run.appeared && run.stopped_ahead && !run.collided && !run.goal_reached;
}

std::vector<ReportTable> planning_tables(const std::vector<PlanningRow>& rows) {
  std::vector<ReportTable> tables{all_plans_table(rows), one_plan_table(rows), spread_table(rows),
                                  findings_table(rows)};
  for (std::size_t t = 0; t + 1 < tables.size(); ++t) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (rows[r].model == "network") {
        tables[t].highlighted_rows.push_back(int(r));
      }
    }
  }
  return tables;
}

std::string tables_to_markdown(const std::string& title, const std::vector<ReportTable>& tables) {
  std::string text = "# " + title + "\n";
  const auto line = [](const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) {
      row += " " + cell + " |";
    }
    return row + "\n";
  };
  for (const ReportTable& table : tables) {
    text += "\n" + table.caption + ".\n\n" + line(table.header) +
            line(std::vector<std::string>(table.header.size(), "---"));
    for (const std::vector<std::string>& row : table.rows) {
      text += line(row);
    }
  }
  return text;
}

}  // namespace limber
