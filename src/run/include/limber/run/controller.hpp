#pragma once
// For those who write a controller.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

struct ExecutionResult;

/// What a controller is told when a run begins. All that is borrowed outlives the run.
struct RunStart {
  const ArmDescription& arm;
  const Plan& plan;   ///< certified; it is never changed
  double hold_s;      ///< ExecutionSettings::hold_s
  bool in_real_time;  ///< a set point is due in each frame, also while somebody thinks
  std::vector<PressureLimits> limits;  ///< ArmDriver::limits_kpa
};

/// What a controller decides. Neither set points nor question: the run ends.
struct Decision {
  /// Of the next frame, size n. Within the arm's limits, and no farther from the last ones than the
  /// frame rule allows (`within_frame_rule`).
  std::optional<Pressures> setpoint_kpa = std::nullopt;
  /// Something that takes long, such as a search: one at a time. In simulated time it is answered
  /// before anything else happens, so that runs can be repeated. In real time it is worked out on
  /// another thread, and `step` goes on being asked for set points meanwhile (Moment::is_thinking).
  /// It leaves its answer with the controller, copies what it needs, and touches nothing that
  /// `step` touches.
  std::function<void()> question = {};

  /// The plan and its frame that these set points stand for, which the prediction's error is taken
  /// from; frames after its end are the last one's. None: nothing was predicted.
  const Plan* plan = nullptr;
  std::size_t frame = 0;
  int motion = 0;               ///< Episode::motion_index of the frame
  bool begins_at_rest = false;  ///< a further plan: the first one's hold has ended
  bool is_certified = true;     ///< from where the arm is, as far as the controller looks at that

  std::string reason = {};     ///< of an end before its time
  bool has_left_plan = false;  ///< an end before the plan's: none leads on
};

/// The moment at which a controller decides.
struct Moment {
  ArmEstimate& arm;          ///< after the last frame
  bool is_thinking = false;  ///< the last question is still being worked out, in real time
};

/// Decides what an arm is sent, frame by frame. Open loop, the closed loop, feedback by Jacobians,
/// tracking of a path and chains of plans are controllers; so is yours (examples/cpp and
/// examples/python, 11_your_own_controller).
///
/// The executor asks `step` before each frame, holds the answer against the frame rule and the
/// arm's limits, sends it through the safety gate, and lets the estimate observe what follows.
/// Threads: all calls come from one; a question may run on another.
class Controller {
 public:
  virtual ~Controller() = default;

  /// What the run's estimate predicts with. Asked once, before `begin`.
  virtual EstimateModel estimate_with() const { return {}; }
  /// The arm stands where the plan starts. Those that follow plans run once.
  virtual void begin(const RunStart& start) { (void)start; }
  /// Set points of the next frame, a question, or the end.
  virtual Decision step(const Moment& now) = 0;
  /// An obstacle has appeared: from now on the environment is this one, which outlives the run.
  /// Said between frames, while no question is being worked out.
  virtual void obstacle_appeared(const Environment& now) { (void)now; }
  /// Somebody else has held the arm for a frame: what is being worked out comes too late.
  virtual void held() {}
  /// What it has noticed of the arm since it was asked last, in words; empty: nothing. Asked in
  /// each frame, for ExecutionSettings::on_frame.
  virtual std::string take_notice() { return {}; }
  /// Whether it makes plans of its own: the message of a run that missed speaks of them.
  virtual bool plans_again() const { return false; }
  /// Adds what the controller did (replans, waits, …) to the result of a run that has ended.
  virtual void report(ExecutionResult& result) const { (void)result; }
};

/// The closed loop, for ExecutionSettings::controller: plans again from where the arm is measured,
/// while it moves and after (docs/planning.md, Closed loop). A search takes 2000 queries while the
/// arm moves, 20 000 when it stands. Without tracking the run is open loop. Borrows arm,
/// environment and what the model borrows. One run. Threads: as Controller.
/// @param adapts  a model that `adapt` made from a family: which arm of it this is, is followed
///                while it moves (ExecutionResult::arm)
/// @throws InputError if the model is of another arm, or has no network
std::unique_ptr<Controller> make_closed_loop(const ArmDescription& arm, const MotionModel& model,
                                             const Environment& environment, const ErrorRoom& room,
                                             std::uint64_t seed, bool adapts = true);

}  // namespace limber
