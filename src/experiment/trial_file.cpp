#include "trial_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/units.hpp"
#include "limber/hardware/execution_report.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr PlanStatus kPlanStatuses[] = {PlanStatus::solved,           PlanStatus::limit,
                                        PlanStatus::no_solution,      PlanStatus::invalid_start,
                                        PlanStatus::goal_unreachable, PlanStatus::goal_in_collision,
                                        PlanStatus::not_certified};
constexpr ExecutionStatus kExecutionStatuses[] = {ExecutionStatus::done, ExecutionStatus::fault,
                                                  ExecutionStatus::stopped};

template <class Status, std::size_t count>
Status status_named(const std::string& name, const Status (&all)[count]) {
  for (const Status status : all) {
    if (name == to_string(status)) {
      return status;
    }
  }
  throw InputError(fmt::format("status '{}' found", name));
}

fs::path trial_path(const fs::path& folder, const std::string& id) {
  return folder / "trials" / (id + ".json");
}

fs::path plan_path(const fs::path& folder, const std::string& id) {
  return folder / "plans" / (id + ".json");
}

ExecutionResult read_execution(const Json& json) {
  ExecutionResult run;
  run.status = status_named(json.at("status").get<std::string>(), kExecutionStatuses);
  run.message = json.at("message").get<std::string>();
  run.collided = json.at("collided").get<bool>();
  run.goal_reached = json.at("goal_reached").get<bool>();
  run.frames = json.at("frames").get<int>();
  if (!json.at("final_backbone").is_null()) {
    run.goal_error.position_m = json.at("distance_to_goal_cm").get<double>() / kCmPerM;
    run.goal_error.orientation_rad = json.at("orientation_to_goal_rad").get<double>();
    const Json& rows = json.at("final_backbone");
    Backbone backbone(static_cast<Eigen::Index>(rows.size()), 3);
    for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        backbone(i, k) =
            rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)].get<float>();
      }
    }
    run.final_backbone = std::move(backbone);
  }
  return run;
}

PlanTrial read_fields(const Json& json) {
  PlanTrial trial;
  trial.environment = json.at("environment").get<std::string>();
  trial.model = json.at("model").get<std::string>();
  trial.planner = json.at("planner").get<std::string>();
  trial.seed = json.at("seed").get<std::uint64_t>();
  trial.planning.status = status_named(json.at("status").get<std::string>(), kPlanStatuses);
  trial.planning.reason = json.at("reason").get<std::string>();
  const Json& first = json.at("first_solution");
  if (!first.is_null()) {
    trial.planning.first_solution =
        FirstSolution{first.at("time_s").get<double>(), first.at("cost_kpa").get<double>(),
                      first.at("queries").get<std::uint64_t>()};
  }
  for (const Json& event : json.value("events", Json::array())) {
    trial.planning.events.push_back(
        {event.at("time_s").get<double>(), 0, event.at("nodes").get<std::uint64_t>(),
         event.at("queries").get<std::uint64_t>(), event.at("best_cost_kpa").get<double>()});
  }
  trial.planning.statistics.time_s = json.at("time_s").get<double>();
  trial.planning.statistics.iterations = json.at("iterations").get<std::uint64_t>();
  trial.planning.statistics.queries = json.at("queries").get<std::uint64_t>();
  trial.planning.statistics.nodes = json.at("nodes").get<std::uint64_t>();
  if (!json.at("execution").is_null()) {
    trial.execution = read_execution(json.at("execution"));
  }
  return trial;
}

}  // namespace

void write_trial(const fs::path& folder, const std::string& id, const PlanTrial& trial,
                 const Environment& environment) {
  if (trial.planning.plan) {
    write_plan(plan_path(folder, id), *trial.planning.plan);
  }
  Json json = planning_to_json(trial, environment);
  json["execution"] =
      trial.execution ? execution_to_json(*trial.execution, environment) : Json(nullptr);
  write_file_atomically(trial_path(folder, id), json.dump(1) + "\n");
}

bool has_trial(const fs::path& folder, const std::string& id) {
  return fs::exists(trial_path(folder, id));
}

PlanTrial read_trial(const fs::path& folder, const std::string& id,
                     const Environment& environment) {
  const fs::path path = trial_path(folder, id);
  try {
    PlanTrial trial = read_fields(Json::parse(read_file(path)));
    trial.asks_heading = environment.goal.theta_rad.has_value();
    if (trial.solved()) {
      trial.planning.plan = read_plan(plan_path(folder, id));
    }
    return trial;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: no trial of limber experiment: {}; remove it to run it again",
                                 path.string(), error.what()));
  }
}

}  // namespace limber
