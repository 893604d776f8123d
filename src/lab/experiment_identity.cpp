#include "experiment_identity.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/planning/forest.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

std::string forest_hash(const Forest& forest) {
  return content_hash({reinterpret_cast<const char*>(forest.setpoints_kpa.data()),
                       static_cast<std::size_t>(forest.setpoints_kpa.size()) * sizeof(float)});
}

}  // namespace

nlohmann::ordered_json experiment_identity(const ExperimentSettings& settings,
                                           const std::string& model_hash) {
  Json json;
  json["schema"] = "limber/experiment/1";
  json["arm"] = {{"name", settings.arm.name}, {"hash", settings.arm.hash()}};
  json["virtual_arm"] = content_hash(virtual_arm_to_yaml(settings.arm));
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

void require_same_experiment(const std::filesystem::path& file, const nlohmann::json& wanted) {
  const nlohmann::json root = read_json_object(file);
  nlohmann::json all = wanted;
  all.emplace("tube", nullptr);  // written where it is asked for alone
  for (const auto& [key, value] : all.items()) {
    const nlohmann::json there = root.value(key, nlohmann::json(nullptr));
    if (there != value) {
      throw InputError(fmt::format(
          "{}: {} = {}; this run has {}: --resume continues the same experiment only; choose "
          "another --out, or drop --resume",
          file.string(), key, in_few_words(there), in_few_words(value)));
    }
  }
}

}  // namespace limber
