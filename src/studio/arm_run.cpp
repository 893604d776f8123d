#include "arm_run.hpp"

#include <list>
#include <utility>

#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/driver/driver_run.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/scene_json.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/world/environment.hpp"
#include "project_folder.hpp"

namespace limber {

namespace {

void require_allowed(const Plan& plan, const std::vector<PressureLimits>& limits_kpa,
                     const std::string& whose) {
  if (const auto found = first_beyond(plan, limits_kpa)) {
    throw InputError(fmt::format(
        "the plan asks for {:.1f} {unit} in {}; {} allows {} {unit}. Nothing was moved. Raise the "
        "limit scale, or plan within it",
        found->value, segment_name(found->segment), whose, to_string(found->limits),
        fmt::arg("unit", plan.command.unit)));
  }
}

std::string with_more(const std::string& message, const std::string& more) {
  return message + (message.empty() || more.empty() ? "" : "; ") + more;
}

/// Takes in a run frame by frame, for the page and for its end.
class FrameWatch {
 public:
  FrameWatch(const ArmRunJob& job, const StudioScene& scene, const ArmControl& control,
             const std::function<void(const Json&)>& on_frame)
      : control_(control),
        on_frame_(on_frame),
        track_("arm", scene.arm(), job.found.environment.obstacles) {}

  void take(const ExecutedFrame& frame) {
    if (frame.appeared != nullptr) {
      obstacle_ = obstacle_to_json(frame.appeared->obstacles.back());
      track_.add_obstacle(frame.appeared->obstacles.back());
    }
    noticed_ = with_more(noticed_, std::string(frame.noticed));
    add(frame.state);
    setpoints_kpa_.push_back(pressures_to_json(frame.setpoint_kpa));
    on_frame_({{"time_s", frame.time_s},
               {"setpoint_kpa", setpoints_kpa_.back()},
               {"pressure_kpa", pressures_to_json(frame.state.pressure_kpa)},
               {"shape", shape_ ? shape_to_json(*shape_) : Json()},
               {"obstacle", obstacle_},
               {"noticed", noticed_},
               {"holds", control_.why_held()}});
  }

  Json json(const Plan& plan, const ExecutionResult& result, const PoseGoal& goal) {
    track_.set_outcome(outcome_text(goal, result));
    return {{"frame_rate_hz", plan.frame_rate_hz},
            {"setpoints_kpa", setpoints_kpa_},
            {"appeared", appeared_to_json(result.appeared)},
            {"tracks", shape_ ? Json::array({track_.json()}) : Json::array()}};
  }

 private:
  /// Frames before it is first seen wait until then.
  void add(const ArmState& state) {
    if (state.backbone) {
      shape_ = *state.backbone;
      for (const Pressures& kpa : std::exchange(unseen_kpa_, {})) {
        track_.add(kpa, *shape_, false);
      }
    }
    if (shape_) {
      track_.add(state.pressure_kpa, *shape_, state.backbone.has_value());
    } else {
      unseen_kpa_.push_back(state.pressure_kpa);
    }
  }

  const ArmControl& control_;
  const std::function<void(const Json&)>& on_frame_;
  MotionTrack track_;
  std::optional<Backbone> shape_;      // where it was seen last; none: never yet
  std::vector<Pressures> unseen_kpa_;  // until then
  Json setpoints_kpa_ = Json::array();
  Json obstacle_ = nullptr;
  std::string noticed_;  // so far: a slow page misses frames
};

/// What `limber verify` repeats: the run's plan as 00.json, those after it as 01.json, …, and as
/// 00.yaml, … what each was certified for.
void write_plans(const fs::path& folder, const FoundPlan& first,
                 const std::list<FollowedPlan>& further, const std::string& model_hash) {
  int number = 0;
  const auto write = [&](const Plan& plan, const Environment& environment) {
    const std::string file = (folder / fmt::format("{:02}", number++)).string();
    write_file_atomically(file + ".yaml", environment_to_yaml(environment));
    write_plan(file + ".json", plan);
  };
  write(first.plan, first.environment);
  for (FollowedPlan followed : further) {
    followed.plan.model_hash = model_hash;
    write(followed.plan, followed.environment);
  }
}

/// Of the message of a vent, what whoever stands beside the arm has to know.
std::string with_vent(const std::string& message, const ProcessDriver& driver) {
  return with_more(message, driver.last_vent().message);
}

}  // namespace

std::string keep_arm(const fs::path& recording, const StudioScene& scene,
                     const ExecutionResult& result) {
  const bool has_changed =
      result.arm && (result.arm_changed_s.has_value() || !result.arm_changes.empty());
  if (!has_changed || !has_run(result)) {
    return "";
  }
  const auto file = fs::path(recording).replace_extension(".safetensors");
  write_model(file, model_after_run(*scene.network(), *result.arm));
  return fmt::format("plan with {}/{} from now on: it has what the run told of the arm",
                     file.parent_path().filename().string(), file.filename().string());
}

ArmRunReport run_on_arm(const ArmRunJob& job, const StudioScene& scene,
                        ProcessDriverSettings driver_settings, const fs::path& recording,
                        ArmControl& control, const std::function<void(const Json&)>& on_frame) {
  const ArmDescription& arm = scene.arm();
  const Environment& environment = job.found.environment;
  const Plan& plan = job.found.plan;
  require_allowed(plan, limits_of(with_scaled_limits(arm, job.limit_scale)),
                  fmt::format("a limit scale of {:g}", job.limit_scale));
  ClosedLoopSettings loop_settings;
  if (job.replan) {
    loop_settings.motion_queries = queries_within(kMotionSearchS, arm, scene.motion());
  }
  driver_settings.limit_scale = job.limit_scale;
  driver_settings.vent_asked = [&control] { return control.must_vent(); };
  driver_settings.log = free_name(recording.string() + ".driver", ".", ".jsonl");
  ProcessDriver driver(arm, driver_settings);
  require_allowed(plan, driver.limits_kpa(), "the driver");
  if (!driver.is_real_time()) {
    control.note_unheld();
  }

  FrameWatch watch(job, scene, control, on_frame);
  bool has_begun = false;
  ExecutionSettings settings;
  settings.max_start_error_m = allowed_start_error_m(plan);
  // An arm that is on its way to a start under pressure is not held there, but vented.
  settings.should_stop = [&] { return control.must_vent() || (!has_begun && control.must_hold()); };
  settings.should_hold = [&control] { return control.must_hold(); };
  settings.on_frame = [&](const ExecutedFrame& frame) {
    has_begun = true;
    watch.take(frame);
  };
  std::optional<ClosedLoop> loop;
  if (job.replan) {
    loop.emplace(arm, scene.motion(), environment, error_room(scene.motion().forward()),
                 loop_settings, plan.seed);
    settings.controller = &*loop;
  }
  const std::optional<AppearingObstacle> obstacle = dropped_obstacle(job.drop_obstacle, arm, plan);
  settings.obstacle = obstacle ? &*obstacle : nullptr;

  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  if (result.episode.frame_count() > 0) {
    write_recording(recording, recording_of(arm, describe(driver), plan, result,
                                            job.replan ? std::optional(loop_settings.motion_queries)
                                                       : std::nullopt));
  }
  write_plans(fs::path(recording).replace_extension(ProjectFolder::kPlansOfRun), job.found,
              loop ? loop->further_plans() : std::list<FollowedPlan>(), scene.model_hash());
  // A fault is told also where somebody pressed VENT after it.
  const std::string why =
      result.status == ExecutionStatus::stopped ? control.why_vented() : std::string();
  return {with_more(with_vent(why.empty() ? result.message : why, driver),
                    keep_arm(recording, scene, result)),
          watch.json(plan, result, environment.goal)};
}

}  // namespace limber
