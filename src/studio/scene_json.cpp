#include "scene_json.hpp"

#include <cmath>
#include <set>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/report/scene_json.hpp"

namespace limber {

namespace {

using Cells = std::set<std::pair<int, int>>;

/// With those that samples missed: most of their neighbours are reached.
Cells without_holes(const Cells& cells) {
  constexpr int kMost = 5;  // of eight neighbours
  Cells filled = cells;
  for (const auto& [column, row] : cells) {
    for (int k = 0; k < 9; ++k) {
      const std::pair<int, int> cell(column + k % 3 - 1, row + k / 3 - 1);
      int neighbours = 0;
      for (int j = 0; j < 9; ++j) {
        neighbours +=
            j != 4 ? int(cells.count({cell.first + j % 3 - 1, cell.second + j / 3 - 1})) : 0;
      }
      if (neighbours >= kMost) {
        filled.insert(cell);
      }
    }
  }
  return filled;
}

}  // namespace

/// JSON is YAML: the reader of files reads it, with all of its checks.
Environment environment_from_json(const nlohmann::json& json, const ArmDescription& arm) {
  refuse_if(!json.is_object(), "environment: expected an object");
  nlohmann::json file = json;
  file["schema"] = "limber/environment/1";
  return read_environment(YamlReader::from_text(file.dump(), "environment"), arm);
}

Json plan_to_json(const Plan& plan) {
  Json json = {{"cost_kpa", plan.cost_kpa},
               {"duration_s", plan.duration_s()},
               {"frame_rate_hz", plan.frame_rate_hz},
               {"clearance_m", json_number(plan.clearance_m)},
               {"goal_distance_m", plan.goal_distance_m}};
  json["tube"] = nullptr;
  if (plan.tube) {
    json["tube"] = {{"level", plan.tube->level},
                    {"plate_radius_m", plan.tube->plate_radius_m},
                    {"start_share", plan.tube->growth.start_share},
                    {"full_after_m", plan.tube->growth.full_after_m}};
  }
  json["setpoints_kpa"] = setpoints_to_json(plan);
  json["pressures_kpa"] = Json::array();
  json["shapes"] = Json::array();
  for (const PlanFrame& frame : plan.frames) {
    json["pressures_kpa"].push_back(pressures_to_json(frame.pressure_kpa));
    json["shapes"].push_back(shape_to_json(frame.backbone));
  }
  return json;
}

Json progress_to_json(const PlannerProgress& progress) {
  return {{"time_s", progress.time_s},
          {"nodes", progress.nodes},
          {"queries", progress.queries},
          {"best_cost_kpa", json_number(progress.best_cost_kpa)}};
}

Json tree_to_json(const std::vector<TreeEdge>& tree, std::size_t max_edges) {
  Json numbers = Json::array();
  for (std::size_t i = 0; i < std::min(tree.size(), max_edges); ++i) {
    for (const float value :
         {tree[i].from_m.x(), tree[i].from_m.y(), tree[i].to_m.x(), tree[i].to_m.y()}) {
      numbers.push_back(rounded_to(double(value), 1e4));
    }
  }
  return numbers;
}

Json reach_to_json(const ArmDescription& arm) {
  constexpr int kSamples = 40000;
  constexpr double kCellsOverLength = 60.0;
  constexpr double kAtLimit = 0.4;  // of the samples: rims of the region are at pressure limits
  const double cell_m = arm.length_m() / kCellsOverLength;
  const NoLoadModel model(arm);
  RandomStream random(1, 0);
  Pressures kpa(arm.channel_count());
  Backbone shape(arm.point_count(), kPoseSize);
  Cells cells;
  for (int sample = 0; sample < kSamples; ++sample) {
    for (Eigen::Index i = 0; i < kpa.size(); ++i) {
      const PressureLimits& limits = arm.segments[i].pressure_limit_kpa;
      const bool at_limit = random.uniform() < kAtLimit;
      const double inside = random.uniform(limits.lower_kpa, limits.upper_kpa);
      kpa[i] = float(!at_limit ? inside : inside < 0.0 ? limits.lower_kpa : limits.upper_kpa);
    }
    model.backbone(Eigen::Ref<const Eigen::VectorXf>(kpa), Eigen::Ref<Backbone>(shape));
    const Eigen::Vector2d tip_m = tip_position_m(shape);
    cells.emplace(int(std::floor(tip_m.x() / cell_m)), int(std::floor(tip_m.y() / cell_m)));
  }
  Json middles = Json::array();
  for (const auto& [column, row] : without_holes(cells)) {
    middles.push_back(rounded_to((column + 0.5) * cell_m, 1e4));
    middles.push_back(rounded_to((row + 0.5) * cell_m, 1e4));
  }
  return {{"cell_m", cell_m}, {"middles_m", middles}};
}

}  // namespace limber
