#include "limber/report/run_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

bool is_run_of(const PlanTrial& trial, const RunRow& row) {
  return trial.model == row.model && trial.planner == row.planner &&
         trial.controller == row.controller && trial.disturbance == row.disturbance;
}

Json run_figures(const SampleFigures& figures) {
  return {{"mean", json_number(figures.mean)},
          {"median", json_number(figures.median)},
          {"p95", json_number(figures.p95)}};
}

}  // namespace

void RunCount::add(const PlanTrial& trial) {
  const auto found = std::ranges::find_if(
      all_, [&](const Counted& counted) { return is_run_of(trial, counted.row); });
  if (found != all_.end()) {
    add_run(trial, *found);
    return;
  }
  Counted& counted = all_.emplace_back();
  counted.row.model = trial.model;
  counted.row.planner = trial.planner;
  counted.row.controller = trial.controller;
  counted.row.disturbance = trial.disturbance;
  add_run(trial, counted);
}

void RunCount::add_run(const PlanTrial& trial, Counted& counted) {
  if (!trial.execution) {
    return;
  }
  const ExecutionResult& run = *trial.execution;
  RunRow& row = counted.row;
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
    counted.distance_cm.push_back(kCmPerM * run.goal_error.position_m);
  }
  counted.replans.push_back(run.replans);
  if (has_arrived(run) && run.goal_time_s && run.planned_goal_time_s.value_or(0.0) > 0.0) {
    counted.goal_time_ratio.push_back(*run.goal_time_s / *run.planned_goal_time_s);
  }
  if (trial.planning.plan && trial.planning.plan->frame_count() > 1) {
    counted.time_ratio.push_back(run.frames / double(trial.planning.plan->frame_count() - 1));
  }
}

std::vector<RunRow> RunCount::rows() const {
  std::vector<RunRow> rows;
  for (const Counted& counted : all_) {
    RunRow& row = rows.emplace_back(counted.row);
    row.distance_cm = figures_of(counted.distance_cm);
    row.goal_time_ratio = figures_of(counted.goal_time_ratio);
    row.time_ratio = figures_of(counted.time_ratio);
    row.replans = figures_of(counted.replans);
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
