#pragma once
// For those who move an arm, real or virtual.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/run/collision_watch.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

struct AppearingObstacle;
class Controller;

enum class ExecutionStatus {
  done,    ///< every frame was commanded, and the hold after them; or halted, it rests in the goal
  fault,   ///< the arm failed; `message` says how
  stopped  ///< by Ctrl-C, or by a controller; `message` says why
};

const char* to_string(ExecutionStatus status);

/// @throws InputError naming frame, segment and limit if a controller's set points break them, or
/// are not one for each channel.
void require_frame_rule(const ArmDescription& arm, int frame, const Pressures& before_kpa,
                        const Pressures& setpoint_kpa);

/// The set points nearest to `wanted_kpa`, each by itself, that keep them; NaN stays before_kpa.
Pressures within_frame_rule(const ArmDescription& arm, const Pressures& before_kpa,
                            const Eigen::Ref<const Eigen::VectorXd>& wanted_kpa);
/// The same with other limits, one for each segment, and another step.
Pressures within_frame_rule(const std::vector<PressureLimits>& limits, double step_limit_kpa,
                            const Pressures& before_kpa,
                            const Eigen::Ref<const Eigen::VectorXd>& wanted_kpa);

/// One frame of a run, after its set points were sent, or its start; borrowed.
struct ExecutedFrame {
  double time_s = 0.0;  ///< since the run's start, which is at 0
  const Pressures& setpoint_kpa;
  const ArmState& state;
  const Environment* appeared = nullptr;  ///< with the obstacle, if that has just appeared
  std::string_view noticed = {};          ///< just noticed of the arm, in words
};

struct ExecutionSettings {
  /// The last set point is held this long in all, including the plan's own hold (which is never
  /// cut); then the goal is judged. [s], ≥ 0.
  double hold_s = 1.0;
  /// Decides what is sent, and when the run ends; borrowed. None: the plan, open loop.
  Controller* controller = nullptr;
  /// Appears during the run; borrowed (internal/limber/run/appearing_obstacle.hpp).
  const AppearingObstacle* obstacle = nullptr;
  /// Asked before every set point; true stops the execution as Ctrl-C does. Empty: never.
  std::function<bool()> should_stop = {};
  /// Asked before every set point, in real time only; while true the last set points are sent again
  /// and nobody decides about others. Empty: never.
  std::function<bool()> should_hold = {};
  /// Told of the start, then of every frame; the next one waits for it. Empty: nobody is.
  std::function<void(const ExecutedFrame&)> on_frame = {};
  /// A start whose plates are seen farther than that from the plan's is refused; none: any start.
  std::optional<double> max_start_error_m;
};

/// Distance between predicted and executed tip over the plan's frames.
struct ExecutedError {
  double mean_m = 0.0;
  double before_hold_m = 0.0;  ///< mean over the frames before the plan's hold: while it moves
  double max_m = 0.0;
  double final_m = 0.0;  ///< at the plan's last frame; NaN if it was not seen at the end
};

/// An obstacle that was not there when the run began.
struct AppearedObstacle {
  double time_s = 0.0;  ///< since the run's start
  Circle circle;
};

/// What advice in motion took to work out, in real time; in simulated time nothing is noted.
struct AdviceTimes {
  std::vector<double> all_s;
  std::vector<double> searches_s;  ///< of it, what searched for another plan
  int late = 0;                    ///< came after its frame, and was dropped
};

struct ExecutionResult {
  ExecutionStatus status = ExecutionStatus::done;
  std::string message;      ///< why it did not arrive: what ended it, or what it missed or struck
  std::string hint;         ///< the end of any: what may help, and what has changed of the arm
  int frames = 0;           ///< set points commanded, those of the hold included
  int frames_not_seen = 0;  ///< of them, those after which the arm was not tracked
  int lag_frames = 0;       ///< ArmEstimate::lag_frames at the end: the episode shows so much less
  /// Before the first set point: largest distance of a plate from where the plan starts.
  double start_error_m = 0.0;

  bool collided = false;  ///< was seen to; without `final_backbone`, false says nothing
  std::optional<Contact> first_collision;
  /// Where the arm came closest; none without obstacles, or without `final_backbone` unless it
  /// collided.
  std::optional<Contact> closest;

  /// After the hold, or at the fault; none if the arm was not tracked in the last 0.25 s: then
  /// nobody knows where it ended.
  std::optional<Backbone> final_backbone;
  PoseError goal_error;                     ///< of it; meaningless without `final_backbone`
  bool goal_reached = false;                ///< was seen to
  std::optional<ExecutedError> prediction;  ///< none if nothing was tracked

  int replans = 0;   ///< plans after the first that started at rest
  int switches = 0;  ///< plans that another one replaced in mid-motion
  int waits = 0;     ///< frames in which the arm waited in mid-motion
  int halts = 0;     ///< plans that were left before their end, since the arm strayed
  /// Frames in which nothing was certified from where the arm was: it went on along what was
  /// certified last, then held.
  int frames_not_certified = 0;
  AdviceTimes advice;
  /// Which arm of the model's family this is, as a closed loop that adapts has it at the end.
  std::optional<FamilyMember> arm;
  /// … when it first moved far from what was predicted; what of its physics may have changed since
  /// the run began, the likeliest first,
  std::optional<double> arm_changed_s;
  std::vector<ArmChange> arm_changes;
  /// … and what that was worth: over the windows of frames that it was fitted to, the largest error
  /// of the plates' places before, and the last one. [m]
  double largest_window_error_m = 0.0;
  double last_window_error_m = 0.0;
  std::vector<PressureLoss> pressure_losses;  ///< ArmEstimate's
  std::optional<AppearedObstacle> appeared;
  /// A plan was left before its end, and none was found that leads on: the arm held and stayed.
  bool stopped_ahead = false;
  /// Where the first plan's hold ended, if more plans followed.
  std::optional<PoseError> open_loop_goal_error;

  /// When the tip came into the goal's region for good, and when the first plan would have it
  /// there; none if it was not there at the end. [s]
  std::optional<double> goal_time_s;
  std::optional<double> planned_goal_time_s;

  /// What was commanded and measured, time 0 being the start; no frames if nothing was tracked.
  /// A motion is one edge of the plan, the hold belongs to the last one.
  Episode episode;
};

/// Whether it says what becomes of a plan: a run that was stopped does, a fault does not.
inline bool has_run(const ExecutionResult& result) {
  return result.status != ExecutionStatus::fault;
}

/// Whether it was seen to end in its goal, clear of everything on its way.
inline bool has_arrived(const ExecutionResult& result) {
  return result.goal_reached && !result.collided;
}

/// The run as a file keeps it. @param source  what moved, in words
/// @param motion_queries  of a closed loop, ClosedLoopSettings; none: the run was open loop
Recording recording_of(const ArmDescription& arm, const std::string& source, const Plan& plan,
                       const ExecutionResult& result, std::optional<std::uint64_t> motion_queries);

/// The environment in which the run ended: an obstacle that appeared is the last one.
Environment with_appeared(const Environment& environment, const ExecutionResult& result);

/// Commands a plan's frames as they stand, one frame period each, then holds; or what a controller
/// decides, no faster than the plan was asked to move (PlanSettings::rate_limit_kpa_per_s).
/// Whatever happens (end, fault, Ctrl-C, exception), the arm is vented before this returns. If the
/// plan starts under pressure, the arm is led there first, straight in pressure space, and held for
/// 3 s, and until it is there (60 s at most), unrecorded.
///
/// Collision is judged on the backbones that the driver returns, once per frame.
/// @throws InputError if plan, environment and arm don't belong together (hashes in the
/// message), or the arm is too far from where the plan starts.
[[nodiscard]] ExecutionResult execute(const ArmDescription& arm, const Environment& environment,
                                      const Plan& plan, ArmDriver& driver,
                                      const ExecutionSettings& settings = {});

/// An arm whose true shape is known, as a simulator's is (limber/sim/virtual_arm.hpp).
struct TrueShape {
  std::function<BackboneD()> now;
  /// Passes on a function that takes every shape the arm comes through, with its time; an empty
  /// one ends that.
  std::function<void(std::function<void(double time_s, const BackboneD& backbone)>)> observe;
};

/// The same, but collisions, goal and prediction are judged on the true shapes, also between
/// frames, whatever noise the driver adds to measured ones.
[[nodiscard]] ExecutionResult execute(const ArmDescription& arm, const Environment& environment,
                                      const Plan& plan, ArmDriver& driver, const TrueShape& truth,
                                      const ExecutionSettings& settings);

}  // namespace limber
