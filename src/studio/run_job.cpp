#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

/// A motion frame by frame, the first one the start, and what is said about it.
struct Track {
  const char* key = "";  ///< "simple", "network" or "virtual_arm"
  std::string outcome;
  Json shapes = Json::array();
  Json pressures_kpa = Json::array();

  void add(const Eigen::Ref<const Pressures>& kpa, const Eigen::Ref<const Backbone>& shape) {
    pressures_kpa.push_back(pressures_to_json(kpa));
    shapes.push_back(shape_to_json(shape));
  }
  Json json() const {
    return {
        {"key", key}, {"outcome", outcome}, {"shapes", shapes}, {"pressures_kpa", pressures_kpa}};
  }
};

std::string miss_text(const PoseGoal& goal, const Backbone& shape) {
  constexpr double kCmPerM = 100.0;
  const Pose tip = tip_pose(shape);
  const double miss_m = std::hypot(tip.x_m - goal.x_m, tip.y_m - goal.y_m);
  return fmt::format("ends {:.2f} cm from the goal's centre", kCmPerM * miss_m);
}

Track track_of_model(const char* key, const MotionModel& model, const FoundPlan& found,
                     const ArmDescription& arm) {
  Track track;
  track.key = key;
  MotionState state = state_of(start_state(found.environment, arm), model);
  MotionModel::Workspace workspace;
  const std::vector<PlanFrame>& frames = found.plan.frames;
  track.add(state.pressure_kpa(), state.backbone);
  for (std::size_t k = 1; k < frames.size(); ++k) {
    model.step(frames[k].setpoint_kpa, state, workspace);
    track.add(state.pressure_kpa(), state.backbone);
  }
  track.outcome = miss_text(found.environment.goal, state.backbone);
  return track;
}

Track track_of_virtual_arm(const FoundPlan& found, const ArmDescription& arm,
                           const std::atomic<bool>& stop) {
  ExecutionSettings settings;
  settings.should_stop = [&stop] { return stop.load(); };
  VirtualArm driver(arm);
  const ExecutionResult result = execute(arm, found.environment, found.plan, driver, settings);
  Track track;
  track.key = "virtual_arm";
  const Episode& episode = result.episode;
  for (int k = 0; k < episode.frame_count(); ++k) {
    track.add(episode.pressure_kpa.row(k).transpose(), backbone_at(episode.backbone, k));
  }
  track.outcome = !has_run(result)  ? result.message
                  : result.collided ? "strikes: " + result.message
                  : result.final_backbone
                      ? miss_text(found.environment.goal, *result.final_backbone) +
                            (result.goal_reached ? ", arrives" : ", misses it")
                      : result.message;
  return track;
}

}  // namespace

void run_run_job(const RunJob& job, const StudioScene& scene, const FoundPlan& found,
                 const std::atomic<bool>& stop, EventQueue& events) {
  Json json = {{"request", job.request},
               {"frame_rate_hz", found.plan.frame_rate_hz},
               {"tracks", Json::array()}};
  json["setpoints_kpa"] = Json::array();
  for (const PlanFrame& frame : found.plan.frames) {
    json["setpoints_kpa"].push_back(pressures_to_json(frame.setpoint_kpa));
  }
  json["tracks"].push_back(track_of_model("simple", scene.simple(), found, scene.arm()).json());
  if (scene.has_network()) {
    json["tracks"].push_back(track_of_model("network", scene.motion(), found, scene.arm()).json());
  }
  if (scene.has_virtual_arm()) {
    json["tracks"].push_back(track_of_virtual_arm(found, scene.arm(), stop).json());
  }
  if (!stop) {
    events.push("run", json.dump());
  }
}

}  // namespace limber
