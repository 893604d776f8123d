#include "limber/report/run_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

struct RunSamples {
  std::vector<double> distance_cm, goal_time_ratio, time_ratio, replans;
};

bool is_run_of(const PlanTrial& trial, const RunRow& row) {
  return trial.model == row.model && trial.planner == row.planner &&
         trial.controller == row.controller && trial.disturbance == row.disturbance;
}

void add_run(const PlanTrial& trial, RunRow& row, RunSamples& samples) {
  if (!trial.execution) {
    return;
  }
  const ExecutionResult& run = *trial.execution;
  if (!has_run(run)) {
    ++row.faults;
    return;
  }
  ++row.executed;
  row.stopped += run.status == ExecutionStatus::stopped ? 1 : 0;
  row.reached += has_arrived(run) ? 1 : 0;
  row.collided += run.collided ? 1 : 0;
  row.stopped_ahead += is_clean_stop(run) ? 1 : 0;
  row.appeared += run.appeared ? 1 : 0;
  if (run.final_backbone && !is_clean_stop(run)) {
    samples.distance_cm.push_back(kCmPerM * run.goal_error.position_m);
  }
  samples.replans.push_back(run.replans);
  if (has_arrived(run) && run.goal_time_s && run.planned_goal_time_s.value_or(0.0) > 0.0) {
    samples.goal_time_ratio.push_back(*run.goal_time_s / *run.planned_goal_time_s);
  }
  if (trial.planning.plan && trial.planning.plan->frame_count() > 1) {
    samples.time_ratio.push_back(run.frames / double(trial.planning.plan->frame_count() - 1));
  }
}

Json run_figures(const SampleFigures& figures) {
  return {{"mean", json_number(figures.mean)},
          {"median", json_number(figures.median)},
          {"p95", json_number(figures.p95)}};
}

}  // namespace

std::vector<RunRow> run_rows(const std::vector<PlanTrial>& trials) {
  std::vector<RunRow> rows;
  std::vector<RunSamples> samples;
  for (const PlanTrial& trial : trials) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [&](const RunRow& row) { return is_run_of(trial, row); });
    const auto index = static_cast<std::size_t>(found - rows.begin());
    if (found == rows.end()) {
      RunRow row;
      row.model = trial.model;
      row.planner = trial.planner;
      row.controller = trial.controller;
      row.disturbance = trial.disturbance;
      rows.push_back(std::move(row));
      samples.emplace_back();
    }
    add_run(trial, rows[index], samples[index]);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].distance_cm = figures_of(samples[i].distance_cm);
    rows[i].goal_time_ratio = figures_of(samples[i].goal_time_ratio);
    rows[i].time_ratio = figures_of(samples[i].time_ratio);
    rows[i].replans = figures_of(samples[i].replans);
  }
  return rows;
}

Json to_json(const std::vector<RunRow>& rows) {
  Json list = Json::array();
  for (const RunRow& row : rows) {
    list.push_back({{"model", row.model},
                    {"planner", row.planner},
                    {"controller", row.controller},
                    {"disturbance", row.disturbance},
                    {"executed", row.executed},
                    {"reached", row.reached},
                    {"collided", row.collided},
                    {"stopped", row.stopped},
                    {"stopped_ahead", row.stopped_ahead},
                    {"obstacles_appeared", row.appeared},
                    {"faults", row.faults},
                    {"distance_to_goal_cm", run_figures(row.distance_cm)},
                    {"goal_time_over_plan", run_figures(row.goal_time_ratio)},
                    {"time_over_plan", run_figures(row.time_ratio)},
                    {"replans", run_figures(row.replans)}});
  }
  return list;
}

ReportTable run_table(const std::vector<RunRow>& rows) {
  ReportTable table;
  table.caption =
      "All environments together. Clean stops: clear of everything, for an obstacle that had "
      "appeared. Distance of all other runs. Times over the plan's: until the tip is in the goal "
      "for good, of runs that arrive, and of the whole run";
  table.header = {"Model",
                  "Planner",
                  "Controller",
                  "Disturbance",
                  "Arrived",
                  "Collided",
                  "Clean stops",
                  "Distance, median (cm)",
                  "95 % (cm)",
                  "Time to the goal, median",
                  "Whole run, median"};
  for (const RunRow& row : rows) {
    const auto of_all = [&](int count) { return fmt::format("{} of {}", count, row.executed); };
    table.rows.push_back({row.model == "network" ? "Network" : "No load", row.planner,
                          row.controller, row.disturbance.empty() ? "none" : row.disturbance,
                          of_all(row.reached), of_all(row.collided), of_all(row.stopped_ahead),
                          shown(row.distance_cm.median, 2), shown(row.distance_cm.p95, 2),
                          shown(row.goal_time_ratio.median, 2), shown(row.time_ratio.median, 2)});
  }
  return table;
}

}  // namespace limber
