#include "limber/report/run_table.hpp"

#include <algorithm>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/cpu_level.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/units.hpp"
#include "limber/common/version.hpp"

namespace limber {

namespace {

bool is_run_of(const PlanTrial& trial, const RunRow& row) {
  return trial.model == row.model && trial.planner == row.planner &&
         trial.controller == row.controller && trial.disturbance == row.disturbance;
}

Json run_figures(const SampleFigures& figures) {
  return {{"mean", json_number(figures.mean)},
          {"median", json_number(figures.median)},
          {"p95", json_number(figures.p95)}};
}

constexpr const char* kProperties =
    "time REAL\n"
    "solved BOOLEAN\n"
    "correct solution BOOLEAN\n"
    "solution length REAL\n"
    "first solution time REAL\n"
    "first solution length REAL\n"
    "graph states INTEGER\n"
    "model queries INTEGER\n"
    "status ENUM\n";
constexpr int kPropertyCount = 9;

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string run_line(const PlanTrial& trial) {
  const PlanResult& planning = trial.planning;
  std::optional<double> cost, first_s, first_cost;
  if (trial.solved()) {
    cost = planning.plan->cost_kpa;
  }
  if (planning.first_solution) {
    first_s = planning.first_solution->time_s;
    first_cost = planning.first_solution->cost_kpa;
  }
  return fmt::format("{}; {}; {}; {}; {}; {}; {}; {}; {}; \n", planning.statistics.time_s,
                     trial.solved() ? 1 : 0, trial.solved() ? 1 : 0, number(cost), number(first_s),
                     number(first_cost), planning.statistics.nodes, planning.statistics.queries,
                     int(planning.status));
}

/// How the best cost fell: "time,cost,;time,cost,;…".
std::string progress_line(const PlanTrial& trial) {
  std::string line;
  for (const PlannerProgress& event : trial.planning.events) {
    line += fmt::format("{},{},;", event.time_s, *event.best_cost_kpa);
  }
  return line + "\n";
}

}  // namespace

void RunCount::add(const PlanTrial& trial) {
  auto found = std::ranges::find_if(
      all_, [&](const Counted& counted) { return is_run_of(trial, counted.row); });
  if (found == all_.end()) {
    found = all_.emplace(found);
    found->row.model = trial.model;
    found->row.planner = trial.planner;
    found->row.controller = trial.controller;
    found->row.disturbance = trial.disturbance;
  }
  add_run(trial, *found);
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
  return mapped<Json>(rows, [&](const RunRow& row) {
    return Json{{"model", row.model},
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
                {"replans", run_figures(row.replans)}};
  });
}

ReportTable run_table(const std::vector<RunRow>& rows) {
  ReportTable table{
      "All environments together. Clean stops: clear of everything, for an obstacle that had "
      "appeared. Distance of all other runs. Times over the plan's: until the tip is in the goal "
      "for good, of runs that arrive, and of the whole run",
      {"Model", "Planner", "Controller", "Disturbance", "Arrived", "Collided", "Clean stops",
       "Distance, median (cm)", "95 % (cm)", "Time to the goal, median", "Whole run, median"}};
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

std::string planner_arena_log(const std::string& environment, const std::vector<PlanTrial>& trials,
                              const PlannerLimits& limits, std::uint64_t seed) {
  std::vector<std::string> planners;
  std::vector<std::vector<const PlanTrial*>> runs;
  double total_s = 0.0;
  for (const PlanTrial& trial : trials) {
    if (trial.environment != environment) {
      continue;
    }
    const std::string name = fmt::format("control_{}_{}", trial.planner, trial.model);
    const auto found = std::find(planners.begin(), planners.end(), name);
    const auto index = std::size_t(found - planners.begin());
    if (found == planners.end()) {
      planners.push_back(name);
      runs.emplace_back();
    } else if (trial.controller != runs[index].front()->controller ||
               trial.disturbance != runs[index].front()->disturbance) {
      continue;  // the same plans, executed in another way
    }
    runs[index].push_back(&trial);
    total_s += trial.planning.statistics.time_s;
  }
  std::string statuses = "status";
  for (const PlanStatus status : kPlanStatuses) {
    statuses += std::string("|") + to_string(status);
  }
  const std::time_t now = std::time(nullptr);
  std::string log = fmt::format(
      "limber version {}\nExperiment {}\nRunning on {}\nStarting at {:%Y-%m-%d %H:%M:%S}\n"
      "<<<|\nlengths are costs, in the command's unit; states hold commands and shapes\n|>>>\n"
      "{} is the random seed\n{} seconds per run\n{} MB per run\n{} runs per planner\n"
      "{} seconds spent to collect the data\n1 enum type\n{}\n{} planners\n",
      version(), environment, host_name(), fmt::gmtime(now), seed, limits.time_s.value_or(0.0),
      limits.memory_mb.value_or(0.0), runs.empty() ? 0 : runs.front().size(), total_s, statuses,
      planners.size());
  for (std::size_t i = 0; i < planners.size(); ++i) {
    log += fmt::format("{}\n0 common properties\n{} properties for each run\n{}{} runs\n",
                       planners[i], kPropertyCount, kProperties, runs[i].size());
    for (const PlanTrial* trial : runs[i]) {
      log += run_line(*trial);
    }
    log += fmt::format("2 progress properties for each run\ntime REAL\nbest cost REAL\n{} runs\n",
                       runs[i].size());
    for (const PlanTrial* trial : runs[i]) {
      log += progress_line(*trial);
    }
    log += ".\n";
  }
  return log;
}

}  // namespace limber
