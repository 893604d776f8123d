#include "experiment_folder.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/world/environment.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxLooks = 200;  // at files of a kind, for one of a hash

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

Json run_to_json(const std::string& id, const nlohmann::json& trial) {
  const nlohmann::json execution = trial.value("execution", nlohmann::json());
  Json json = {{"id", id}};
  for (const char* key : {"status", "cost_kpa"}) {
    json[key] = value_or_null(trial, key);
  }
  for (const char* key : {"goal_reached", "collided", "stopped_ahead", "distance_to_goal_cm"}) {
    json[key] = value_or_null(execution, key);
  }
  return json;
}

/// The first of the project's files that `fits`. @param first  begins with files of that name
template <class Fits>
std::string find_by_hash(const ProjectFolder& project, ProjectItem kind, const std::string& first,
                         const char* what, const Fits& fits) {
  std::vector<std::string> names = project.names(kind);
  std::stable_partition(names.begin(), names.end(), [&](const std::string& name) {
    return fs::path(name).stem() == first || name.ends_with(":" + first);
  });
  names.resize(std::min(names.size(), kMaxLooks));
  for (const std::string& name : names) {
    try {
      if (fits(project.find(kind, name))) {
        return name;
      }
    } catch (const InputError&) {  // a file of another arm, or a broken one
    }
  }
  throw InputError(fmt::format(
      "the {} that this plan was made for is not in the project folder, or it has changed since: "
      "copy the file that limber experiment used into the folder",
      what));
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
      runs.push_back(run_to_json(id, trial));
    }
    if (runs.size() == kMaxRuns) {
      break;
    }
  }
  return runs;
}

ExperimentFolder::Run ExperimentFolder::run(const std::string& id) const {
  const nlohmann::json trial = read("trials/" + id + ".json");
  const JsonReader belongs = JsonReader(trial, id).at("belongs_to");
  const nlohmann::json settings = read("experiment.json");
  const JsonReader arm_was = JsonReader(settings, name_ + "/experiment.json").at("arm");
  if (belongs.at("plan").is_null()) {
    throw InputError(id + ": no plan was found in this trial");
  }
  const fs::path file = project_.inside(name_ + "/plans/" + id + ".json");
  Run run{{}, "", read_plan(file)};
  if (!run.plan.certified) {
    throw InputError(id + ": the plan has no certificate");
  }
  run.scene.arm = find_by_hash(
      project_, ProjectItem::arm, arm_was.at("name").text(), "arm",
      [&](const fs::path& path) { return load_arm(path).hash() == arm_was.at("hash").text(); });
  const ArmDescription arm = load_arm(project_.find(ProjectItem::arm, run.scene.arm));
  require_plan_of(run.plan, arm, id);
  run.environment = find_by_hash(
      project_, ProjectItem::environment, belongs.at("environment").text(), "environment",
      [&](const fs::path& path) {
        return environment_hash(load_environment(path, arm)) == run.plan.environment_hash;
      });
  if (!run.plan.model_hash.empty()) {
    run.scene.model =
        find_by_hash(project_, ProjectItem::model, "", "network",
                     [&](const fs::path& path) { return file_hash(path) == run.plan.model_hash; });
  }
  return run;
}

}  // namespace limber
