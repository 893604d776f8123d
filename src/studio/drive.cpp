#include <deque>
#include <optional>
#include <thread>

#include "jobs.hpp"
#include "limber/common/json.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/report/scene_json.hpp"
#include "limber/run/executor.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

constexpr double kRestS = 3.0;  // after the last change of a set point everything has settled
constexpr std::size_t kMemory = 1200;  // frames, a minute: what an arm still shows of its past

MotionState rest_of(const MotionModel& model, const ArmDescription& arm) {
  return state_of(start_state(Environment(), arm), model);
}

/// The network, as any arm of its family: another arm stands where the same set points would have
/// brought it from rest.
class DrivenNetwork {
 public:
  explicit DrivenNetwork(const StudioScene& scene)
      : scene_(scene), state_(rest_of(scene.motion(), scene.arm())) {}

  void step(const Pressures& setpoint_kpa) {
    setpoints_kpa_.push_back(setpoint_kpa);
    if (setpoints_kpa_.size() > kMemory) {
      setpoints_kpa_.pop_front();
    }
    motion().step(setpoint_kpa, state_, workspace_);
  }
  /// @return whether it is another arm now
  bool become(const Eigen::VectorXf& e) {
    if (e.size() == e_.size() && e == e_) {
      return false;
    }
    e_ = e;
    other_motion_.reset();
    other_.reset();
    if (e.size() > 0) {
      other_.emplace(scene_.model_of(e));
      other_motion_.emplace(scene_.motion_of(*other_));
    }
    state_ = rest_of(motion(), scene_.arm());
    for (const Pressures& kpa : setpoints_kpa_) {
      motion().step(kpa, state_, workspace_);
    }
    return true;
  }
  const Backbone& backbone() const { return state_.backbone; }

 private:
  const MotionModel& motion() const { return other_motion_ ? *other_motion_ : scene_.motion(); }

  const StudioScene& scene_;
  Eigen::VectorXf e_;
  std::optional<ForwardModel> other_;
  std::optional<MotionModel> other_motion_;
  MotionState state_;
  MotionModel::Workspace workspace_;
  std::deque<Pressures> setpoints_kpa_;
};

/// The same set points for the simple model, the network and the virtual arm, from rest.
class DrivenArms {
 public:
  explicit DrivenArms(const StudioScene& scene)
      : scene_(scene),
        setpoint_kpa_(Pressures::Zero(scene.arm().channel_count())),
        simple_(rest_of(scene.simple(), scene.arm())) {
    if (scene.has_network()) {
      network_.emplace(scene);
    }
    if (scene.has_virtual_arm()) {
      virtual_arm_.emplace(scene.arm());
    }
  }

  /// Whether a frame towards the target changes the set points.
  bool moves_towards(const Pressures& target_kpa) const {
    return next_kpa(target_kpa) != setpoint_kpa_;
  }
  /// One frame towards the target, as fast as the arm's rate allows.
  void step(const Pressures& target_kpa) {
    setpoint_kpa_ = next_kpa(target_kpa);
    scene_.simple().step(setpoint_kpa_, simple_, workspace_);
    if (network_) {
      network_->step(setpoint_kpa_);
    }
    if (virtual_arm_) {
      virtual_arm_->command(setpoint_kpa_);
    }
    ++frame_;
  }
  /// @return whether the network is another arm of its family now
  bool become(const Eigen::VectorXf& e) { return network_ && network_->become(e); }

  Json json() const {
    Json json = {{"time_s", frame_ * scene_.arm().frame_period_s()},
                 {"setpoint_kpa", pressures_to_json(setpoint_kpa_)}};
    json["simple"] = shape_to_json(simple_.backbone);
    json["network"] = network_ ? shape_to_json(network_->backbone()) : Json(nullptr);
    json["virtual_arm"] =
        virtual_arm_ ? shape_to_json(*virtual_arm_->state().backbone) : Json(nullptr);
    return json;
  }

 private:
  Pressures next_kpa(const Pressures& target_kpa) const {
    return within_frame_rule(scene_.arm(), setpoint_kpa_, target_kpa.cast<double>());
  }

  const StudioScene& scene_;
  Pressures setpoint_kpa_;
  MotionState simple_;
  std::optional<DrivenNetwork> network_;
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
    DriveTo to = target.get();
    if (to.kpa.size() != scene.arm().channel_count()) {
      to.kpa = Pressures::Zero(scene.arm().channel_count());
    }
    frames_at_rest = arms.moves_towards(to.kpa) ? 0 : frames_at_rest + 1;
    const bool goes_on = frames_at_rest <= rest_frames;  // else time stands still for all of them
    if (goes_on) {
      arms.step(to.kpa);
    }
    if (arms.become(to.e) || goes_on) {
      Json json = arms.json();
      json["request"] = job.request;
      events.push("drive", json.dump());
    }
    due = std::max(due + period, Clock::now() - period);  // a late frame is not caught up on
    std::this_thread::sleep_until(due);
  }
}

}  // namespace limber
