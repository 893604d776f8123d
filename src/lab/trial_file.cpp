#include "trial_file.hpp"

#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/units.hpp"
#include "limber/common/utf8.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/track_report.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
constexpr double kFarthest = 1e6;   // [m, rad]; nothing real comes near
constexpr double kLongest_s = 1e8;  // three years: no trial took that long
constexpr std::array kExecutionStatuses{ExecutionStatus::done, ExecutionStatus::fault,
                                        ExecutionStatus::stopped};

template <class Status, std::size_t count>
Status read_status(const JsonReader& field, const std::array<Status, count>& all) {
  const std::string name = field.text();
  std::string names;
  for (const Status status : all) {
    if (name == to_string(status)) {
      return status;
    }
    names += (names.empty() ? "" : ", ") + std::string(to_string(status));
  }
  field.refuse_found("expected one of " + names);
}

std::string trial_name(const std::string& id) {
  return "trials/" + id + ".json";
}

std::string plan_name(const std::string& id) {
  return "plans/" + id + ".json";
}

// In the order of the file; every one is compared.
std::vector<std::pair<const char*, std::string>> texts_of(const TrialKey& key) {
  std::vector<std::pair<const char*, std::string>> texts = {
      {"id", key.id},
      {"experiment", key.experiment},
      {"environment", key.environment},
      {"environment_hash", key.environment_hash},
      {"model", key.model},
      {"model_hash", key.model_hash},
      {"planner", key.planner},
      {"seed", std::to_string(key.seed)}};
  // As usual: not written, so that trials of before are still read.
  if (key.controller != "open") {
    texts.emplace_back("controller", key.controller);
  }
  if (!key.disturbance.empty()) {
    texts.emplace_back("disturbance", key.disturbance);
  }
  return texts;
}

void require_same(const JsonReader& field, const std::string& found, const std::string& wanted) {
  if (found != wanted) {
    field.refuse_found(fmt::format("this trial is of '{}'", wanted));
  }
}

void require_key(const JsonReader& field, const TrialKey& key) {
  for (const auto& [name, wanted] : texts_of(key)) {
    require_same(field.at(name), field.at(name).text(), wanted);
  }
}

/// What it says of itself at its top, for whoever reads it: the same as its key.
void require_names(const JsonReader& json, const TrialKey& key) {
  for (const auto& [name, wanted] :
       {std::pair{"environment", key.environment}, std::pair{"model", key.model},
        std::pair{"planner", key.planner}}) {
    require_same(json.at(name), json.at(name).text(), wanted);
  }
  require_same(json.at("seed"), std::to_string(json.at("seed").count(kAny)),
               std::to_string(key.seed));
}

Backbone read_backbone(const JsonReader& field, const ArmDescription& arm) {
  const std::vector<JsonReader> rows = field.elements("a list of poses [x_m, y_m, theta_rad]");
  field.refuse_if(rows.size() != std::size_t(arm.point_count()),
                  "{} poses found; expected {}, one per plate of arm '{}'", rows.size(),
                  arm.point_count(), arm.name);
  Backbone backbone(arm.point_count(), kPoseSize);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> pose =
        rows[i].numbers(kPoseSize, "numbers [x_m, y_m, theta_rad]", -kFarthest, kFarthest);
    for (Eigen::Index k = 0; k < kPoseSize; ++k) {
      backbone(Eigen::Index(i), k) = float(pose[k]);
    }
  }
  return backbone;
}

AppearedObstacle read_appeared(const JsonReader& json) {
  return {json.at("time_s").number(0.0, kLongest_s),
          {json.at("x_m").number(), json.at("y_m").number(), json.at("radius_m").number(0.0)}};
}

/// None where there is none, and in trials that were written before it was.
std::optional<double> read_time(const JsonReader& json, const char* key) {
  return json.has(key) && !json.at(key).is_null()
             ? std::optional(json.at(key).number(0.0, kLongest_s))
             : std::nullopt;
}

/// Of an arm that was not seen nobody knows.
bool read_known(const JsonReader& json) {
  return !json.is_null() && json.boolean();
}

ExecutionResult read_execution(const JsonReader& json, const ArmDescription& arm) {
  ExecutionResult run;
  run.status = read_status(json.at("status"), kExecutionStatuses);
  run.message = json.at("message").text();
  run.collided = read_known(json.at("collided"));
  run.goal_reached = read_known(json.at("goal_reached"));
  run.frames = json.at("frames").integer(0, std::numeric_limits<int>::max());
  run.replans = json.at("replans").integer(0, std::numeric_limits<int>::max());
  run.goal_time_s = read_time(json, "goal_time_s");
  run.planned_goal_time_s = read_time(json, "planned_goal_time_s");
  if (json.has("stopped_ahead")) {
    run.stopped_ahead = json.at("stopped_ahead").boolean();
  }
  if (json.has("obstacle_appeared") && !json.at("obstacle_appeared").is_null()) {
    run.appeared = read_appeared(json.at("obstacle_appeared"));
  }
  if (!json.at("final_backbone").is_null()) {
    run.goal_error.position_m =
        json.at("distance_to_goal_cm").number(0.0, kFarthest * kCmPerM) / kCmPerM;
    if (const JsonReader turn = json.at("orientation_to_goal_rad"); !turn.is_null()) {
      run.goal_error.orientation_rad = turn.number(0.0, kFarthest);  // of a goal with a heading
    }
    run.final_backbone = read_backbone(json.at("final_backbone"), arm);
  }
  return run;
}

PlannerProgress read_event(const JsonReader& event) {
  PlannerProgress progress;
  progress.time_s = event.at("time_s").number(0.0, kLongest_s);
  progress.nodes = event.at("nodes").count(kAny);
  progress.queries = event.at("queries").count(kAny);
  progress.best_cost_kpa = event.at("best_cost_kpa").number(0.0);
  return progress;
}

PlanTrial read_fields(const JsonReader& json, const TrialKey& key, const ArmDescription& arm) {
  require_names(json, key);
  PlanTrial trial;
  trial.environment = key.environment;
  trial.model = key.model;
  trial.planner = key.planner;
  trial.controller = key.controller;
  trial.disturbance = key.disturbance;
  trial.seed = key.seed;
  PlanResult& planning = trial.planning;
  planning.status = read_status(json.at("status"), kPlanStatuses);
  planning.reason = json.at("reason").text();
  const JsonReader first = json.at("first_solution");
  if (!first.is_null()) {
    planning.first_solution = FirstSolution{
        first.at("time_s").number(0.0, kLongest_s), first.at("cost_kpa").number(0.0),
        first.at("queries").count(kAny), json.at("first_candidate_s").number(0.0, kLongest_s),
        json.at("first_certificate_s").number(0.0, kLongest_s)};
  }
  for (const JsonReader& event : json.at("events").elements("a list of events")) {
    planning.events.push_back(read_event(event));
  }
  planning.statistics.time_s = json.at("time_s").number(0.0, kLongest_s);
  planning.statistics.iterations = json.at("iterations").count(kAny);
  planning.statistics.queries = json.at("queries").count(kAny);
  planning.statistics.nodes = json.at("nodes").count(kAny);
  const JsonReader execution = json.at("execution");
  if (!execution.is_null()) {
    trial.execution = read_execution(execution, arm);
  }
  // Tables take a plan's first solution and run for granted.
  for (const JsonReader& part : {first, execution}) {
    if (part.is_null() == trial.solved()) {
      part.refuse_found(fmt::format("expected {}, as status is {}",
                                    trial.solved() ? "an object" : "null",
                                    to_string(planning.status)));
    }
  }
  return trial;
}

/// The plan that was written with the trial, and no other.
Plan read_trial_plan(const fs::path& path, const JsonReader& hash, const TrialKey& key,
                     const ArmDescription& arm) {
  if (const std::string found = file_hash(path); hash.text() != found) {
    hash.refuse_found(
        fmt::format("{} has the hash '{}': another plan, or a changed one", path.string(), found));
  }
  Plan plan = read_plan(path);
  const auto require = [&](const char* field, const std::string& found, const std::string& wanted) {
    if (found != wanted) {
      throw InputError(fmt::format("{}: {}: '{}' found; this trial is of '{}'", path.string(),
                                   field, shortened(found), wanted));
    }
  };
  require("environment.hash", plan.environment_hash, key.environment_hash);
  require("model.kind", plan.model, key.model);
  require("model.hash", plan.model_hash, key.model_hash);
  require("seed", std::to_string(plan.seed), std::to_string(key.seed));
  require_plan_of(plan, arm, path.string());
  if (!plan.certified) {
    throw InputError(path.string() + ": certificate: missing");
  }
  return plan;
}

}  // namespace

void write_trial(OutputFolder& folder, const TrialKey& key, const PlanTrial& trial,
                 const Environment& environment) {
  Json belongs = Json::object();
  for (const auto& [name, text] : texts_of(key)) {
    belongs[name] = text;
  }
  belongs["plan"] = nullptr;
  if (trial.planning.plan) {
    const std::string name = plan_name(key.id);
    folder.write_with({name}, [&] { write_plan(folder.path() / name, *trial.planning.plan); });
    belongs["plan"] = file_hash(folder.path() / name);
  }
  Json json = planning_to_json(trial, environment);
  json["execution"] = trial.execution ? to_json(*trial.execution, environment) : Json(nullptr);
  json["belongs_to"] = belongs;
  folder.write(trial_name(key.id), json.dump(1) + "\n");
}

bool has_trial(const fs::path& folder, const std::string& id) {
  return fs::exists(folder / trial_name(id));
}

std::vector<std::string> trial_files(const std::string& id) {
  return {trial_name(id), plan_name(id)};
}

PlanTrial read_trial(const fs::path& folder, const TrialKey& key, const ArmDescription& arm,
                     const Environment& environment) {
  const fs::path path = folder / trial_name(key.id);
  try {
    const nlohmann::json root = read_json_object(path);
    const JsonReader json(root, path.string());
    require_key(json.at("belongs_to"), key);
    PlanTrial trial = read_fields(json, key, arm);
    trial.asks_heading = environment.goal.theta_rad.has_value();
    if (trial.solved()) {
      trial.planning.plan =
          read_trial_plan(folder / plan_name(key.id), json.at("belongs_to").at("plan"), key, arm);
    }
    return trial;
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}. The trial is damaged, or another experiment's: "
                    "remove {} and {} to run it again, or choose another --out",
                    error.what(), path.string(), (folder / plan_name(key.id)).string()));
  }
}

}  // namespace limber
