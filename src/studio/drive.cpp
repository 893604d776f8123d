#include <optional>
#include <thread>

#include "jobs.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kRestS = 3.0;  // after the last change of a set point everything has settled

/// The same set points for the simple model, the network and the virtual arm, from rest.
class DrivenArms {
 public:
  explicit DrivenArms(const StudioScene& scene)
      : scene_(scene),
        setpoint_kpa_(Pressures::Zero(scene.arm().channel_count())),
        simple_(rest(scene.simple())),
        network_(rest(scene.motion())) {
    if (scene.has_virtual_arm()) {
      virtual_arm_.emplace(scene.arm());
    }
  }

  /// One frame towards `target_kpa`, as fast as the arm's rate allows. @return whether it moved on
  bool step(const Pressures& target_kpa) {
    const Pressures before_kpa = setpoint_kpa_;
    setpoint_kpa_ = within_frame_rule(scene_.arm(), before_kpa, target_kpa.cast<double>());
    scene_.simple().step(setpoint_kpa_, simple_, workspace_);
    if (scene_.has_network()) {
      scene_.motion().step(setpoint_kpa_, network_, workspace_);
    }
    if (virtual_arm_) {
      virtual_arm_->command(setpoint_kpa_);
    }
    ++frame_;
    return setpoint_kpa_ != before_kpa;
  }

  Json json() const {
    Json json = {{"time_s", frame_ * scene_.arm().frame_period_s()},
                 {"setpoint_kpa", pressures_to_json(setpoint_kpa_)}};
    json["simple"] = shape_to_json(simple_.backbone);
    json["network"] = scene_.has_network() ? shape_to_json(network_.backbone) : Json(nullptr);
    json["virtual_arm"] =
        virtual_arm_ ? shape_to_json(*virtual_arm_->state().backbone) : Json(nullptr);
    return json;
  }

 private:
  MotionState rest(const MotionModel& model) const {
    const ArmStart start = start_state(Environment(), scene_.arm());
    return model.settled_state(start.pressures_kpa, start.backbone);
  }

  const StudioScene& scene_;
  Pressures setpoint_kpa_;
  MotionState simple_;
  MotionState network_;
  std::optional<VirtualArm> virtual_arm_;
  MotionModel::Workspace workspace_;
  int frame_ = 0;
};

}  // namespace

void run_drive_job(const DriveJob& job, const StudioScene& scene, const DriveTarget& target,
                   const std::atomic<bool>& stop, EventQueue& events) {
  using Clock = std::chrono::steady_clock;
  const auto period = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(scene.arm().frame_period_s()));
  const int rest_frames = scene.arm().frames_in(kRestS);
  DrivenArms arms(scene);
  int frames_at_rest = 0;
  Clock::time_point due = Clock::now();
  while (!stop) {
    Pressures kpa = target.get();
    if (kpa.size() != scene.arm().channel_count()) {
      kpa = Pressures::Zero(scene.arm().channel_count());
    }
    frames_at_rest = arms.step(kpa) ? 0 : frames_at_rest + 1;
    if (frames_at_rest <= rest_frames) {
      Json json = arms.json();
      json["request"] = job.request;
      events.push("drive", json.dump());
    }
    due = std::max(due + period, Clock::now() - period);  // a late frame is not caught up on
    std::this_thread::sleep_until(due);
  }
}

}  // namespace limber
