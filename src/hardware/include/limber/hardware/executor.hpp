#pragma once
// For those who move an arm, real or virtual.

#include <optional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/data/recording.hpp"
#include "limber/hardware/arm_driver.hpp"
#include "limber/hardware/collision_watch.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

class VirtualArm;

enum class ExecutionStatus {
  done,    ///< every frame was commanded, and the hold after them
  fault,   ///< the arm failed; `message` says how
  stopped  ///< by Ctrl-C
};

const char* to_string(ExecutionStatus status);

struct ExecutionSettings {
  /// The last set point is held this long in all, the plan's own hold counted (and never cut); then
  /// the goal is judged. [s], ≥ 0.
  double hold_s = 1.0;
  /// A start whose plates are seen farther than that from the plan's is refused; none: any start.
  std::optional<double> max_start_error_m;
};

/// Distance between predicted and executed tip over the plan's frames.
struct ExecutedError {
  double mean_m = 0.0;
  double before_hold_m = 0.0;  ///< mean over the frames before the plan's hold: while it moves
  double max_m = 0.0;
  double final_m = 0.0;  ///< at the plan's last frame
};

struct ExecutionResult {
  ExecutionStatus status = ExecutionStatus::done;
  std::string message;  ///< of a fault or stop; empty otherwise
  int frames = 0;       ///< set points commanded, those of the hold included
  /// Largest distance of a plate from where the plan starts, before the first set point.
  double start_error_m = 0.0;

  bool collided = false;
  std::optional<Contact> first_collision;
  /// Where the arm came closest; none without obstacles, or where nothing was seen of the arm.
  std::optional<Contact> closest;

  std::optional<Backbone> final_backbone;  ///< after the hold, or at the fault; none if untracked
  PoseError goal_error;                    ///< of it; meaningless without `final_backbone`
  bool goal_reached = false;
  std::optional<ExecutedError> prediction;  ///< none where nothing was tracked

  /// What was commanded and measured, time 0 being the start; no frames where nothing was tracked.
  /// A motion is one edge of the plan, the hold belongs to the last.
  Episode episode;
};

/// Commands a plan's frames as they stand, open loop, one frame period each, then holds. Whatever
/// happens (end, fault, Ctrl-C, exception), the arm is vented before this returns. A start under
/// pressure is approached first, straight in pressure space and held 3 s, unrecorded.
///
/// Collision: the backbones that the driver returns, once a frame.
/// @throws InputError where plan, environment and arm don't belong together (hashes in the
/// message), or the arm is too far from where the plan starts.
[[nodiscard]] ExecutionResult execute(const ArmDescription& arm, const Environment& environment,
                                      const Plan& plan, ArmDriver& driver,
                                      const ExecutionSettings& settings = {});

/// The same; collision and clearance of the true backbone at every simulator step, and the true
/// backbone for goal and prediction, whatever noise the driver adds to measured ones.
[[nodiscard]] ExecutionResult execute(const ArmDescription& arm, const Environment& environment,
                                      const Plan& plan, VirtualArm& driver,
                                      const ExecutionSettings& settings = {});

}  // namespace limber
