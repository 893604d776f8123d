#include <optional>

#include "jobs.hpp"
#include "limber/common/json.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/scene_json.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

MotionTrack track_of_model(const char* key, const MotionModel& model, const FoundPlan& found,
                           const ArmDescription& arm) {
  MotionTrack track(key, arm, found.environment.obstacles);
  MotionState state = state_of(start_state(found.environment, arm), model);
  MotionModel::Workspace workspace;
  const std::vector<PlanFrame>& frames = found.plan.frames;
  track.add(state.pressure_kpa(), state.backbone);
  for (std::size_t k = 1; k < frames.size(); ++k) {
    model.step(frames[k].setpoint_kpa, state, workspace);
    track.add(state.pressure_kpa(), state.backbone);
  }
  track.set_outcome(miss_text(found.environment.goal, state.backbone));
  return track;
}

ExecutionResult run_virtual_arm(const RunJob& job, const StudioScene& scene, const FoundPlan& found,
                                const std::atomic<bool>& stop) {
  ExecutionSettings settings;
  settings.should_stop = [&stop] { return stop.load(); };
  std::optional<ClosedLoop> loop;
  if (job.replan) {
    loop.emplace(scene.arm(), scene.motion(), found.environment,
                 error_room(scene.motion().forward()), ClosedLoopSettings{}, found.plan.seed);
    settings.controller = &*loop;
  }
  const std::optional<AppearingObstacle> obstacle =
      dropped_obstacle(job.drop_obstacle, scene.arm(), found.plan);
  settings.obstacle = obstacle ? &*obstacle : nullptr;
  VirtualArm driver(scene.arm());
  return execute(scene.arm(), found.environment, found.plan, driver, settings);
}

}  // namespace

void run_run_job(const RunJob& job, const StudioScene& scene, const FoundPlan& found,
                 const std::atomic<bool>& stop, EventQueue& events) {
  Json json = {{"request", job.request},
               {"frame_rate_hz", found.plan.frame_rate_hz},
               {"tracks", Json::array()}};
  json["setpoints_kpa"] = setpoints_to_json(found.plan);
  json["tracks"].push_back(track_of_model("simple", scene.simple(), found, scene.arm()).json());
  if (scene.has_network()) {
    json["tracks"].push_back(track_of_model("network", scene.motion(), found, scene.arm()).json());
  }
  json["appeared"] = nullptr;
  if (scene.has_virtual_arm()) {
    const ExecutionResult result = run_virtual_arm(job, scene, found, stop);
    if (result.episode.frame_count() > 0) {
      json["setpoints_kpa"] = rows_to_json(result.episode.setpoint_kpa);
    }
    json["appeared"] = appeared_to_json(result.appeared);
    json["tracks"].push_back(
        executed_track("virtual_arm", scene.arm(), found.environment, result).json());
  }
  if (!stop) {
    events.push("run", json.dump());
  }
}

}  // namespace limber
