#include "scene_json.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "limber/arm/no_load_model.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/physical_traits.hpp"
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

/// What e tells of arms: its value by e, the range over the arms that the family learnt from, and
/// how e changes along with it.
Json traits_to_json(const ArmFamily& family) {
  Json list = Json::array();
  for (const PhysicalTrait& trait : family.traits) {
    const TraitWords words = words_of_trait(trait.name);
    const auto in_words = [&](float value) { return words.per_si * double(value); };
    const Eigen::VectorXf told =
        (trait.slope.transpose() * family.arms).transpose().array() + trait.middle;
    const Eigen::VectorXf along = trait.along / float(words.per_si);
    const Eigen::VectorXf slope = float(words.per_si) * trait.slope;
    list.push_back({{"name", trait.name},
                    {"text", words.text},
                    {"unit", words.unit},
                    {"of_arm_file", in_words(trait.of_file)},
                    {"low", in_words(told.minCoeff())},
                    {"high", in_words(told.maxCoeff())},
                    {"middle", in_words(trait.middle)},
                    {"slope", std::vector<float>(slope.begin(), slope.end())},
                    {"along", std::vector<float>(along.begin(), along.end())}});
  }
  return list;
}

constexpr int kCells = 24;  // per side
constexpr int kMaxPairs = 15;

int cell_of(double kpa, const PressureLimits& limits) {
  const double share = (kpa - limits.lower_kpa) / (limits.upper_kpa - limits.lower_kpa);
  return std::clamp(int(share * kCells), 0, kCells - 1);
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
      const double nearer = inside < 0.5 * (limits.lower_kpa + limits.upper_kpa) ? limits.lower_kpa
                                                                                 : limits.upper_kpa;
      kpa[i] = float(at_limit ? nearer : inside);
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

Json family_to_json(const CompensationModel& model) {
  const Eigen::Index size = model.family ? model.family->size() : 0;
  const Eigen::VectorXf e =
      model.member_of_family ? model.member_of_family->e : Eigen::VectorXf::Zero(size);
  return {{"is_family", is_family(model)},
          {"e", std::vector<float>(e.begin(), e.end())},
          {"traits", model.family ? traits_to_json(*model.family) : Json::array()}};
}

Json coverage_to_json(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  Json json = {{"cells", kCells}, {"pairs", Json::array()}};
  const auto segments = int(arm.segments.size());
  for (int i = 0; i < segments; ++i) {
    for (int j = i + 1; j < segments && json["pairs"].size() < kMaxPairs; ++j) {
      std::vector<int> frames(std::size_t{kCells} * kCells, 0);
      const PressureLimits& across = arm.segments[i].pressure_limit_kpa;
      const PressureLimits& up = arm.segments[j].pressure_limit_kpa;
      for (const Episode& episode : episodes) {
        for (Eigen::Index t = 0; t < episode.pressure_kpa.rows(); ++t) {
          const int column = cell_of(double(episode.pressure_kpa(t, i)), across);
          const int row = cell_of(double(episode.pressure_kpa(t, j)), up);
          ++frames[row * kCells + column];
        }
      }
      json["pairs"].push_back({{"segments", {i, j}}, {"frames", frames}});
    }
  }
  return json;
}

}  // namespace limber
