#include "experiment_results.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/planning/forest.hpp"
#include "limber/report/run_table.hpp"
#include "limber/report/shapes_page.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

std::string forest_hash(const Forest& forest) {
  return content_hash({reinterpret_cast<const char*>(forest.setpoints_kpa.data()),
                       std::size_t(forest.setpoints_kpa.size()) * sizeof(float)});
}

// A page with more of them opens slowly, and needs memory for all.
constexpr std::size_t kMostEnvironmentsOnPage = 100;

constexpr std::size_t kEnvironmentsPerFolder = 400;

/// Rows came by environment; tables go by planner, controller and disturbance first.
std::vector<PlanningRow> by_way(const std::vector<PlanningRow>& rows) {
  std::vector<PlanningRow> sorted;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto is_same = [&](const PlanningRow& row) { return is_run_as(row, rows[i]); };
    if (std::ranges::none_of(sorted, is_same)) {
      std::ranges::copy_if(rows, std::back_inserter(sorted), is_same);
    }
  }
  return sorted;
}

}  // namespace

Json experiment_identity(const ExperimentSettings& settings, const std::string& model_hash) {
  Json json;
  json["schema"] = "limber/experiment/1";
  json["arm"] = {{"name", settings.arm.name}, {"hash", settings.arm.hash()}};
  json["virtual_arm"] = virtual_arm_hash(settings.arm);
  json["model"] = model_hash;
  json["valves"] = settings.valves.hash();
  json["margin_m"] = optional_json(settings.room.margin_m);  // null: the model's own
  json["goal_margin_m"] = optional_json(settings.room.goal_margin_m);
  json["goal_margin_rad"] = optional_json(settings.room.goal_margin_rad);
  if (settings.room.tube_level) {
    json["tube"] = *settings.room.tube_level;
  }
  json["seed"] = settings.seed;
  if (!settings.adapts) {
    json["adapts"] = false;
  }
  json["time_limit_s"] = optional_json(settings.limits.time_s);
  json["max_iterations"] = optional_json(settings.limits.iterations);
  json["max_queries"] = optional_json(settings.limits.queries);
  json["max_memory_mb"] = optional_json(settings.limits.memory_mb);
  json["cost_threshold_kpa"] = optional_json(settings.limits.cost_threshold_kpa);
  json["forest"] = settings.forest ? Json(forest_hash(*settings.forest)) : Json(nullptr);
  json["planner_jobs"] = settings.planner_jobs;
  json["environments"] = Json::object();
  for (const EnvironmentCase& item : settings.environments) {
    json["environments"][item.id] = environment_hash(item.environment);
  }
  return json;
}

void require_same_experiment(const fs::path& file, nlohmann::json wanted) {
  for (const char* key : {"adapts", "tube"}) {  // written where they are asked for alone
    wanted.emplace(key, nullptr);
  }
  require_same_run(file, wanted, "experiment only; choose another --out, or drop --resume");
}

ResultNames result_names(const ExperimentSettings& settings, const EnvironmentCase& item) {
  const auto index = std::size_t(&item - settings.environments.data());
  const std::string name = settings.environments.size() > kEnvironmentsPerFolder
                               ? fmt::format("{:03}/{}", index / kEnvironmentsPerFolder, item.id)
                               : item.id;
  return {"figures/" + name + ".svg", "figures/" + name + "_all.svg",
          "planner_arena/" + name + ".log"};
}

void ExperimentResults::add(const EnvironmentCase& item, const std::vector<PlanTrial>& trials) {
  const std::vector<PlanningRow> rows = planning_rows(trials);
  std::vector<PlanTrial> one;
  for (const PlanningRow& row : rows) {
    if (is_run_as(row, rows.front()) && row.one_plan) {
      one.push_back(*row.one_plan);
    }
  }
  std::ranges::copy(rows, std::back_inserter(rows_));
  std::ranges::for_each(trials, [&](const PlanTrial& trial) { runs_.add(trial); });
  const std::string single = final_shapes_picture(settings_.arm, item, one);
  const std::string all = final_shapes_picture(settings_.arm, item, trials);
  const ResultNames names = result_names(settings_, item);
  output_.write(names.one_plan, single);
  output_.write(names.all_plans, all);
  if (figures_.size() < 2 * kMostEnvironmentsOnPage) {
    figures_.push_back({single, item.id + ": one plan of each model"});
    figures_.push_back({all, item.id + ": all plans"});
  }
  output_.write(names.log, planner_arena_log(item.id, trials, settings_.limits, settings_.seed));
}

Json ExperimentResults::write() {
  rows_ = by_way(rows_);
  const Json table = to_json(rows_);
  output_.write("table.json", table.dump(1) + "\n");
  const std::string title =
      fmt::format("Planning and execution, arm {}, {} trials per cell, seed {}", settings_.arm.name,
                  settings_.trials, settings_.seed);
  const std::vector<RunRow> runs = runs_.rows();
  output_.write("runs.json", to_json(runs).dump(1) + "\n");
  std::vector<ReportTable> tables = planning_tables(rows_);
  tables.insert(tables.begin(), run_table(runs));
  output_.write("table.md", tables_to_markdown(title, tables));
  write_report(title, tables);
  return table;
}

void ExperimentResults::write_report(const std::string& title,
                                     const std::vector<ReportTable>& tables) {
  ReportPage page("limber experiment", title);
  page.heading("Tables");
  for (const ReportTable& table : tables) {
    page.table(table);
  }
  page.heading("Final shapes")
      .paragraph(
          "As in the paper's Fig. 5: where the arm ended after executing one plan of each model, "
          "and after all of them. Runs that collided are dashed.");
  if (settings_.environments.size() > kMostEnvironmentsOnPage) {
    page.paragraph(fmt::format("The first {} of {} environments; all are in the folder figures.",
                               kMostEnvironmentsOnPage, settings_.environments.size()));
  }
  for (std::size_t i = 0; i + 1 < figures_.size(); i += 2) {
    page.figures({figures_[i], figures_[i + 1]});
  }
  output_.write("report.html", page.html());
}

}  // namespace limber
