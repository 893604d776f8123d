#include "limber/report/motion_track.hpp"

#include <fmt/format.h>

#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/report/scene_json.hpp"

namespace limber {

void MotionTrack::add(const Eigen::Ref<const Pressures>& kpa,
                      const Eigen::Ref<const Backbone>& shape, bool is_seen) {
  refuse_if(shape.rows() != arm_.point_count(), "a shape of {} plates; arm '{}' has {}",
            shape.rows(), arm_.name, arm_.point_count());
  pressures_kpa_.push_back(pressures_to_json(kpa));
  shapes_.push_back(shape_to_json(shape));
  if (!obstacles_.empty()) {
    clearances_m_.push_back(is_seen ? length_to_json(checker_.clearance(shape).value_m) : Json());
  }
}

void MotionTrack::add_obstacle(const Obstacle& obstacle) {
  while (clearances_m_.size() < shapes_.size()) {
    clearances_m_.push_back(nullptr);  // until now there was nothing
  }
  obstacles_.push_back(obstacle);
  checker_ = CollisionChecker(arm_, obstacles_);
}

Json MotionTrack::json() const {
  return {{"key", key_},
          {"outcome", outcome_},
          {"shapes", shapes_},
          {"pressures_kpa", pressures_kpa_},
          {"clearances_m", clearances_m_}};
}

MotionTrack executed_track(const char* key, const ArmDescription& arm,
                           const Environment& environment, const ExecutionResult& result) {
  MotionTrack track(key, arm, environment.obstacles);
  const Episode& episode = result.episode;
  bool has_appeared = false;
  for (int k = 0; k < episode.frame_count(); ++k) {
    if (result.appeared && !has_appeared &&
        episode.time_s[k] - episode.time_s[0] >= result.appeared->time_s) {
      has_appeared = true;
      track.add_obstacle(result.appeared->circle);
    }
    track.add(episode.pressure_kpa.row(k).transpose(), backbone_at(episode.backbone, k),
              episode.was_tracked(k));
  }
  track.set_outcome(outcome_text(environment.goal, result));
  return track;
}

MotionTrack predicted_track(const ArmDescription& arm, const Environment& environment,
                            const Plan& plan) {
  MotionTrack track(plan.model == "network" ? "network" : "simple", arm, environment.obstacles);
  for (const PlanFrame& frame : plan.frames) {
    track.add(frame.pressure_kpa, frame.backbone);
  }
  track.set_outcome(miss_text(environment.goal, plan.frames.back().backbone));
  return track;
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
         (result.goal_reached ? ", arrives" : ", misses it") + result.hint;
}

Json appeared_to_json(const std::optional<AppearedObstacle>& appeared) {
  if (!appeared) {
    return nullptr;
  }
  return {{"time_s", appeared->time_s}, {"obstacle", obstacle_to_json(appeared->circle)}};
}

}  // namespace limber
