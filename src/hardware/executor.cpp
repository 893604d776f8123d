#include "limber/hardware/executor.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <list>

#include <fmt/format.h>

#include "episode_recorder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/units.hpp"
#include "limber/hardware/schedule.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/world/straight_motion.hpp"
#include "obstacle_appearance.hpp"
#include "vent_guard.hpp"

namespace limber {

namespace {

constexpr double kLongestBlindS = 1.0;  // waited for the arm to be tracked, before the next plan

/// What is known of the arm's shape now: measured, or the truth of a virtual arm.
using Look = std::function<std::optional<BackboneD>()>;

double tip_distance_m(const Backbone& a, const BackboneD& b) {
  const Eigen::Index last = a.rows() - 1;
  return (a.row(last).head<2>().cast<double>() - b.row(last).head<2>()).norm();
}

class Execution {
 public:
  Execution(const ArmDescription& arm, const Environment& environment, const Plan& plan,
            ArmDriver& driver, Look look, const ExecutionSettings& settings)
      : arm_(arm),
        environment_(environment),
        plan_(&plan),
        driver_(driver),
        look_(std::move(look)),
        settings_(settings),
        watch_(arm, environment),
        appearance_(arm, environment, settings.obstacle),
        recorder_(arm) {}

  /// Takes in the arm between frames; what happens before the plan starts does not count.
  void observe(double time_s, const BackboneD& backbone) {
    if (started_) {
      watch_.observe(time_s, backbone);
      appearance_.observe(time_s, backbone);
    }
  }

  ExecutionResult run() {
    const VentGuard vent_at_the_end(driver_);
    try {
      approach_start();
      started_ = true;
      start_time_s_ = driver_.state().time_s;
      note_start();
      require_start();
      recorder_.add(driver_.state(), plan_->frames.front().setpoint_kpa, 0);
      measured_ = driver_.state().backbone.has_value();
      if (settings_.controller != nullptr) {
        follow_controller();
      } else {
        follow();
      }
      while (settings_.controller == nullptr && settings_.replanner != nullptr && go_on()) {
        follow();
      }
    } catch (const SystemFault& fault) {
      result_.status = ExecutionStatus::fault;
      result_.message = fault.what();
    } catch (const Interrupted&) {
      result_.status = ExecutionStatus::stopped;
      result_.message =
          fmt::format("stopped on request after {} frames; the arm was vented", result_.frames);
    }
    judge();
    return std::move(result_);
  }

 private:
  /// The plan, or its beginning where its rest must not be followed, and the hold.
  void follow() {
    const std::vector<PlanFrame>& frames = plan_->frames;
    std::size_t k = 1;
    for (bool goes_on = true; goes_on && k < frames.size(); ++k) {
      command(frames[k].setpoint_kpa);
      compare_with_prediction(k);
      count_motion(frames[k].setpoint_kpa);
      goes_on = k + 1 == frames.size() || settings_.replanner == nullptr ||
                settings_.replanner->may_go_on(*plan_, k, driver_.state());
    }
    const bool halted = k < frames.size();
    result_.halts += halted ? 1 : 0;
    frame_ = k - 1;
    // A plan's own hold counts: planner and executor judge the goal at the same moment.
    for (int held = halted ? 0 : plan_->hold_frame_count; held < arm_.frames_in(settings_.hold_s);
         ++held) {
      command(held_kpa());
    }
  }

  /// Every frame's set points from the controller, until it ends the run.
  void follow_controller() {
    const std::vector<PlanFrame>& frames = plan_->frames;
    Pressures before_kpa = frames.front().setpoint_kpa;
    while (const std::optional<Pressures> next = settings_.controller->next(driver_.state())) {
      require_frame_rule(arm_, result_.frames, before_kpa, *next);
      command(*next);
      before_kpa = *next;
      if (result_.frames < static_cast<int>(frames.size())) {
        compare_with_prediction(static_cast<std::size_t>(result_.frames));
      }
    }
    if (std::string reason = settings_.controller->stop_reason(); !reason.empty()) {
      result_.status = ExecutionStatus::stopped;
      result_.message = std::move(reason);
    }
  }

  const Pressures& held_kpa() const { return plan_->frames[frame_].setpoint_kpa; }

  /// @return whether there is another plan to follow
  bool go_on() {
    const int longest = arm_.frames_in(kLongestBlindS);
    for (int k = 0; k < longest && !driver_.state().backbone; ++k) {
      command(held_kpa());
    }
    std::optional<Plan> next = ask_for_next();
    if (!next) {
      result_.stopped_ahead = frame_ + 1 < plan_->frames.size();
      return false;
    }
    require_plan_of(*next, arm_, "the next plan");
    if (next->frames.front().setpoint_kpa != held_kpa()) {
      throw InputError("the next plan does not start at the set points that the arm holds");
    }
    if (result_.replans++ == 0 && shape_) {
      result_.open_loop_goal_error = pose_error(environment_.goal, tip_pose(*shape_));
    }
    more_plans_.push_back(std::move(*next));
    plan_ = &more_plans_.back();
    first_motion_ = ++motion_;
    return true;
  }

  /// A driver in real time gets its set points while the next plan is searched for; simulated time
  /// stands still meanwhile, so that runs can be repeated.
  std::optional<Plan> ask_for_next() {
    if (!driver_.is_real_time()) {
      return settings_.replanner->next(*plan_, frame_, driver_.state());
    }
    std::future<std::optional<Plan>> next =
        std::async(std::launch::async, [this, state = driver_.state()] {
          return settings_.replanner->next(*plan_, frame_, state);
        });
    try {
      while (next.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        command(held_kpa());
      }
    } catch (...) {
      driver_.vent();  // now, not when the search has ended
      throw;
    }
    return next.get();
  }

  /// Unrecorded: from rest to where the plan starts. The plan takes the arm to have long stood
  /// there, so slow valves get their time.
  void approach_start() {
    const Pressures& start_kpa = plan_->frames.front().setpoint_kpa;
    if (start_kpa.isZero()) {
      return;
    }
    constexpr double kSettlingS = 3.0;  // at least: what full reversals take, and shapes to rest
    constexpr double kLongestSettlingS = 60.0;
    for (const Pressures& setpoint_kpa :
         straight_frames(arm_, Pressures::Zero(arm_.segment_count()), start_kpa)) {
      throw_if_stopped();
      driver_.command(setpoint_kpa);
    }
    const int least = arm_.frames_in(kSettlingS);
    const int most = arm_.frames_in(kLongestSettlingS);
    for (int k = 0; k < least || (k < most && !has_arrived(start_kpa)); ++k) {
      throw_if_stopped();
      driver_.command(start_kpa);
    }
  }

  bool has_arrived(const Pressures& setpoint_kpa) const {
    constexpr double kArrived = 0.01;  // of the limit, as planning's hold has it
    for (Eigen::Index i = 0; i < setpoint_kpa.size(); ++i) {
      const double limit =
          arm_.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa();
      if (!(std::abs(double(driver_.state().pressure_kpa[i]) - double(setpoint_kpa[i])) <=
            kArrived * limit)) {
        return false;
      }
    }
    return true;
  }

  void throw_if_stopped() const {
    throw_if_interrupted();
    if (settings_.should_stop && settings_.should_stop()) {
      throw Interrupted("stopped on request");
    }
  }

  void command(const Pressures& setpoint_kpa) {
    throw_if_stopped();
    const ArmState& state = driver_.command(setpoint_kpa);
    ++result_.frames;
    recorder_.add(state, setpoint_kpa, motion_);
    measured_ = measured_ || state.backbone.has_value();
    see();
    const Environment* now = appearance_.advance(result_.frames, state.time_s, shape_);
    if (now != nullptr && settings_.replanner != nullptr) {
      settings_.replanner->obstacle_appeared(*now);
    }
  }

  /// Takes in the arm's shape of this frame, if there is one.
  void see() {
    if (std::optional<BackboneD> measured = look_()) {
      watch_.observe(driver_.state().time_s, *measured);
      appearance_.observe(driver_.state().time_s, *measured);
      shape_ = std::move(measured);
      shape_frame_ = result_.frames;
    }
  }

  void note_start() {
    see();
    if (shape_) {
      const BackboneD planned = plan_->frames.front().backbone.cast<double>();
      result_.start_error_m = (*shape_ - planned).leftCols<2>().rowwise().norm().maxCoeff();
    }
  }

  void require_start() const {
    if (settings_.max_start_error_m && result_.start_error_m > *settings_.max_start_error_m) {
      throw InputError(fmt::format(
          "the arm is {:.1f} cm from where the plan starts; at most {:.1f} cm are allowed. Plan from "
          "where it is (`start` in the environment file), or allow more (--max-start-error-m)",
          kCmPerM * result_.start_error_m, kCmPerM * *settings_.max_start_error_m));
    }
  }

  void compare_with_prediction(std::size_t frame) {
    if (!shape_ || shape_frame_ != result_.frames) {
      return;
    }
    const double distance_m = tip_distance_m(plan_->frames[frame].backbone, *shape_);
    prediction_.max_m = std::max(prediction_.max_m, distance_m);
    prediction_.final_m = distance_m;
    prediction_sum_m_ += distance_m;
    ++prediction_count_;
    if (static_cast<int>(frame) < plan_->frame_count() - plan_->hold_frame_count) {
      prediction_.before_hold_m = prediction_sum_m_ / prediction_count_;
    }
  }

  /// A motion ends where its edge of the plan does.
  void count_motion(const Pressures& setpoint_kpa) {
    const auto next = static_cast<std::size_t>(motion_ - first_motion_) + 1;
    if (next + 1 < plan_->waypoints_kpa.size() && setpoint_kpa == plan_->waypoints_kpa[next]) {
      ++motion_;
    }
  }

  void judge() {
    if (shape_) {
      result_.final_backbone = shape_->cast<float>();
      result_.goal_error = pose_error(environment_.goal, tip_pose(*shape_));
      result_.goal_reached = result_.status == ExecutionStatus::done &&
                             is_within(environment_.goal, result_.goal_error);
      result_.episode = measured_ ? recorder_.finish() : Episode{};
    }
    if (prediction_count_ > 0) {
      prediction_.mean_m = prediction_sum_m_ / prediction_count_;
      result_.prediction = prediction_;
    }
    const auto since_start = [&](std::optional<Contact> contact) {
      if (contact) {
        contact->time_s -= start_time_s_;
      }
      return contact;
    };
    result_.closest = since_start(appearance_.nearer(watch_.closest()));
    result_.first_collision = since_start(appearance_.earlier(watch_.first_collision()));
    result_.appeared = appearance_.appeared();
    if (result_.appeared) {
      result_.appeared->time_s -= start_time_s_;
    }
    result_.collided = result_.first_collision.has_value();
  }

  const ArmDescription& arm_;
  const Environment& environment_;
  const Plan* plan_;  // the one that is followed
  std::list<Plan> more_plans_;
  std::size_t frame_ = 0;  // the last one of it that was commanded
  ArmDriver& driver_;
  Look look_;
  const ExecutionSettings& settings_;
  CollisionWatch watch_;
  ObstacleAppearance appearance_;
  EpisodeRecorder recorder_;
  ExecutionResult result_;
  std::optional<BackboneD> shape_;
  int shape_frame_ = -1;
  bool started_ = false;
  // Whether some frame was measured; a virtual arm knows its shape even if none was delivered.
  bool measured_ = false;
  int motion_ = 0;
  int first_motion_ = 0;  // of the plan that is followed
  double start_time_s_ = 0.0;
  ExecutedError prediction_;
  double prediction_sum_m_ = 0.0;
  int prediction_count_ = 0;
};

/// Sees every simulator step as long as it lives.
class ObserverGuard {
 public:
  ObserverGuard(VirtualArm& driver, StepObserver observer) : driver_(driver) {
    driver_.set_observer(std::move(observer));
  }
  ~ObserverGuard() { driver_.set_observer({}); }
  ObserverGuard(const ObserverGuard&) = delete;
  ObserverGuard& operator=(const ObserverGuard&) = delete;

 private:
  VirtualArm& driver_;
};

void check(const ArmDescription& arm, const Environment& environment, const Plan& plan,
           const ExecutionSettings& settings) {
  if (plan.frames.empty()) {
    throw InputError("plan: no frames; expected at least its start");
  }
  require_plan_of(plan, arm, "plan");
  const std::string hash = environment_hash(environment);
  if (plan.environment_hash != hash) {
    throw InputError(
        fmt::format("plan: made for environment '{}' (hash {}); this one is '{}' (hash {})",
                    plan.environment_name, plan.environment_hash, environment.name, hash));
  }
  if (!(settings.hold_s >= 0.0) || settings.hold_s > 3600.0) {
    throw InputError(fmt::format("hold_s = {}; expected seconds from 0 to 3600", settings.hold_s));
  }
}

}  // namespace

const char* to_string(ExecutionStatus status) {
  switch (status) {
    case ExecutionStatus::done:
      return "done";
    case ExecutionStatus::fault:
      return "fault";
    default:
      return "stopped";
  }
}

ExecutionResult execute(const ArmDescription& arm, const Environment& environment, const Plan& plan,
                        ArmDriver& driver, const ExecutionSettings& settings) {
  check(arm, environment, plan, settings);
  const Look measured = [&driver]() -> std::optional<BackboneD> {
    const std::optional<Backbone>& backbone = driver.state().backbone;
    return backbone ? std::optional<BackboneD>(backbone->cast<double>()) : std::nullopt;
  };
  return Execution(arm, environment, plan, driver, measured, settings).run();
}

ExecutionResult execute(const ArmDescription& arm, const Environment& environment, const Plan& plan,
                        VirtualArm& driver, const ExecutionSettings& settings) {
  check(arm, environment, plan, settings);
  Execution execution(
      arm, environment, plan, driver,
      [&driver] { return std::optional<BackboneD>(driver.true_backbone()); }, settings);
  const ObserverGuard observer(driver, [&execution](double time_s, const BackboneD& backbone) {
    execution.observe(time_s, backbone);
  });
  return execution.run();
}

}  // namespace limber
