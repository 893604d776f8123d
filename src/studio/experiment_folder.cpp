#include "experiment_folder.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr const char* kTexts[] = {"environment", "model", "planner", "controller", "disturbance"};
constexpr const char* kShown[] = {
    "trials",        "solved",        "executed", "collided",         "reached",
    "not_certified", "stopped_ahead", "cost_psi", "first_solution_s", "distance_to_goal_cm"};

/// Of a row or a trial; what is usual is left out in trials.
std::string text_of(const nlohmann::json& json, const std::string& key) {
  const auto found = json.find(key);
  if (found != json.end() && found->is_string()) {
    return found->get<std::string>();
  }
  return key == "controller" ? "open" : "";
}

bool is_of(const nlohmann::json& row, const nlohmann::json& trial) {
  return std::ranges::all_of(
      kTexts, [&](const char* key) { return text_of(row, key) == text_of(trial, key); });
}

Json value_or_null(const nlohmann::json& json, const char* key) {
  return json.is_object() && json.contains(key) ? Json(json.at(key)) : Json(nullptr);
}

/// @param plan  its name in the project, if there is one
Json run_to_json(const std::string& plan, const nlohmann::json& trial) {
  const nlohmann::json execution = trial.value("execution", nlohmann::json());
  const bool has_plan =
      !value_or_null(trial.value("belongs_to", nlohmann::json()), "plan").is_null();
  Json json = {{"plan", has_plan ? Json(plan) : Json(nullptr)}};
  for (const char* key : {"status", "cost_kpa"}) {
    json[key] = value_or_null(trial, key);
  }
  for (const char* key : {"goal_reached", "collided", "stopped_ahead", "distance_to_goal_cm"}) {
    json[key] = value_or_null(execution, key);
  }
  return json;
}

}  // namespace

std::optional<ExperimentFolder> ExperimentFolder::newest(const ProjectFolder& project) {
  std::optional<ExperimentFolder> newest;
  fs::file_time_type newest_time;
  for (const std::string& name : project.experiments()) {
    std::error_code error;
    const auto time = fs::last_write_time(project.folder() / name / "table.json", error);
    if (!error && (!newest || time > newest_time)) {
      newest.emplace(project, name);
      newest_time = time;
    }
  }
  return newest;
}

ExperimentFolder::ExperimentFolder(const ProjectFolder& project, std::string name)
    : project_(project), name_(std::move(name)) {
  project_.inside(name_ + "/experiment.json");
}

nlohmann::json ExperimentFolder::read(const std::string& file) const {
  return read_json_object(project_.inside(name_ + "/" + file));
}

nlohmann::json ExperimentFolder::table() const {
  // A list, which limber's reader of objects takes as a part of one.
  const std::string text = read_file(project_.inside(name_ + "/table.json"));
  const nlohmann::json object = parse_json_object("{\"rows\":" + text + "}", name_ + "/table.json");
  (void)JsonReader(object, name_ + "/table.json").at("rows").elements("a list of rows");
  return object.at("rows");
}

Json ExperimentFolder::rows() const {
  Json rows = Json::array();
  for (const nlohmann::json& row : table()) {
    if (rows.size() == kMaxRows) {
      break;
    }
    Json shown;
    for (const char* key : kTexts) {
      shown[key] = text_of(row, key);
    }
    for (const char* key : kShown) {
      shown[key] = value_or_null(row, key);
    }
    rows.push_back(std::move(shown));
  }
  return rows;
}

Json ExperimentFolder::runs(std::size_t row) const {
  const nlohmann::json rows = table();
  refuse_if(row >= rows.size(), "row: {} found; the table has {}", row, rows.size());
  const std::string begin =
      fmt::format("{}_{}_", text_of(rows[row], "environment"), text_of(rows[row], "model"));
  std::set<std::string> ids;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(project_.folder() / name_ / "trials", error)) {
    if (file.path().extension() == ".json" && file.path().stem().string().starts_with(begin)) {
      ids.insert(file.path().stem().string());
    }
  }
  Json runs = Json::array();
  for (const std::string& id : ids) {
    const nlohmann::json trial = read("trials/" + id + ".json");
    if (is_of(rows[row], trial.value("belongs_to", nlohmann::json::object()))) {
      runs.push_back(run_to_json(name_ + "/plans/" + id + ".json", trial));
    }
    if (runs.size() == kMaxRuns) {
      break;
    }
  }
  return runs;
}

}  // namespace limber
