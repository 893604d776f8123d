#pragma once
// For those who plan.

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/hold.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

/// The state of an arm that starts there, at rest or in motion.
MotionState state_of(const ArmStart& start, const MotionModel& model);

/// The state at the end of a plan's first frames; before them the arm was at rest.
/// @param start  where the plan starts, if the arm was in motion there
MotionState state_after(const std::vector<PlanFrame>& frames, const MotionModel& model,
                        const ArmStart* start = nullptr);

/// Runs motions along straight lines of set points through the motion model, frame by frame, and
/// checks them for collision. Counts model queries. Threads: one simulator, one thread.
class MotionSimulator {
 public:
  /// Borrows arm, checker and what the model borrows.
  MotionSimulator(const ArmDescription& arm, const MotionModel& model,
                  const CollisionChecker& checker);

  /// Moves from a state to `to_kpa`. Returns false at the first frame that collides, or that is
  /// reached through a collision; `end` is then that frame's state.
  [[nodiscard]] bool move(const MotionState& from, const PressuresRef& to_kpa, MotionState& end);

  /// The same without checking for collisions.
  void move_unchecked(const MotionState& from, const PressuresRef& to_kpa, MotionState& end);

  /// Holds the set points for `frames` frames; otherwise as `move`.
  [[nodiscard]] bool hold(const MotionState& from, int frames, MotionState& end);
  /// The same for as long as hold_frame_count says.
  [[nodiscard]] bool hold(const MotionState& from, MotionState& end);

  /// The state of the arm where a problem starts.
  MotionState start(const ArmStart& start) const { return state_of(start, model_); }

  /// Appends the frames of a motion to `frames`, which holds at least its start.
  /// @param start  of the frames, if the arm was in motion there
  void append_motion(const PressuresRef& to_kpa, std::vector<PlanFrame>& frames,
                     const ArmStart* start = nullptr);
  /// Appends as many frames of holding as hold_frame_count says. @return how many
  int append_hold(std::vector<PlanFrame>& frames, const ArmStart* start = nullptr);

  const CollisionChecker& checker() const { return checker_; }
  const ArmDescription& arm() const { return arm_; }
  const MotionModel& model() const { return model_; }
  std::uint64_t queries() const { return queries_; }
  void count_queries(std::uint64_t queries) { queries_ += queries; }

 private:
  /// One frame of `state_`; its backbone before is left in before_.
  void step(const PressuresRef& setpoint_kpa);
  void append_frame(const PressuresRef& setpoint_kpa, std::vector<PlanFrame>& frames);

  const ArmDescription& arm_;
  MotionModel model_;
  const CollisionChecker& checker_;
  MotionModel::Workspace workspace_;
  std::uint64_t queries_ = 0;
  Pressures setpoint_kpa_;
  Backbone before_;
  MotionState state_;
};

/// Straight motions simulated side by side without checking for collisions; every frame is kept.
/// Threads: as MotionSimulator.
class MotionBatch {
 public:
  /// Borrows the simulator, and counts its queries there.
  explicit MotionBatch(MotionSimulator& simulator)
      : simulator_(simulator), rollouts_(simulator.model()) {}

  /// @param from    states that motions begin in
  /// @param to_kpa  n×k, set points where each goes
  void run(const std::vector<MotionState>& from, const Eigen::Ref<const Eigen::MatrixXf>& to_kpa);

  int frame_count(int motion) const { return int(frames_[motion].cols()) - 1; }
  /// Backbone of `motion` after frame k, 0 ≤ k ≤ frame_count.
  Eigen::Map<const Backbone> frame(int motion, int k) const;
  /// After its last frame.
  const MotionState& end(int motion) const { return ends_[motion]; }
  bool is_free(int motion, const CollisionChecker& checker) const;

 private:
  MotionSimulator& simulator_;
  RolloutBatch rollouts_;
  std::vector<Eigen::MatrixXf> frames_;  // one per motion, 3m × (frames + 1)
  std::vector<MotionState> ends_;
};

}  // namespace limber
