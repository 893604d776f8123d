#include "track.hpp"

#include <fmt/format.h>

#include "limber/common/units.hpp"
#include "limber/sim/disturbance.hpp"
#include "scene_json.hpp"

namespace limber {

using Json = nlohmann::ordered_json;

void Track::add(const Eigen::Ref<const Pressures>& kpa, const Eigen::Ref<const Backbone>& shape) {
  pressures_kpa_.push_back(pressures_to_json(kpa));
  shapes_.push_back(shape_to_json(shape));
  if (!obstacles_.empty()) {
    clearances_m_.push_back(length_to_json(checker_.clearance(shape).value_m));
  }
}

void Track::add_obstacle(const Obstacle& obstacle) {
  while (clearances_m_.size() < shapes_.size()) {
    clearances_m_.push_back(nullptr);  // until now there was nothing
  }
  obstacles_.push_back(obstacle);
  checker_ = CollisionChecker(arm_, obstacles_);
}

Json Track::json() const {
  return {{"key", key_},
          {"outcome", outcome_},
          {"shapes", shapes_},
          {"pressures_kpa", pressures_kpa_},
          {"clearances_m", clearances_m_}};
}

std::string miss_text(const PoseGoal& goal, const Backbone& shape) {
  const Pose tip = tip_pose(shape);
  return fmt::format("ends {:.2f} cm from the goal's centre",
                     kCmPerM * std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m));
}

std::string outcome_text(const PoseGoal& goal, const ExecutionResult& result) {
  if (!has_run(result)) {
    return result.message;
  }
  if (result.collided) {
    return "strikes: " + result.message;
  }
  if (!result.final_backbone || result.status == ExecutionStatus::stopped) {
    return result.message;
  }
  return miss_text(goal, *result.final_backbone) +
         (result.goal_reached ? ", arrives" : ", misses it");
}

Json appeared_to_json(const std::optional<AppearedObstacle>& appeared) {
  if (!appeared) {
    return nullptr;
  }
  return {{"time_s", appeared->time_s}, {"obstacle", obstacle_to_json(appeared->circle)}};
}

std::optional<AppearingObstacle> dropped_obstacle(bool wanted, const ArmDescription& arm,
                                                  const Plan& plan) {
  if (!wanted) {
    return std::nullopt;
  }
  return disturbed(arm, plan, parse_disturbances("obstacle"), plan.seed).obstacle;
}

}  // namespace limber
