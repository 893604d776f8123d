#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/forward/rollout_batch.hpp"
#include "limber/planning/collision.hpp"
#include "limber/planning/plan.hpp"

namespace limber {

using PressuresRef = Eigen::Ref<const Pressures>;
using BackboneRef = Eigen::Ref<const Backbone>;

/// The last pose of a backbone that lies in a larger array.
inline Pose tip_pose(const BackboneRef& backbone) {
  const auto last = backbone.row(backbone.rows() - 1);
  return {double(last[0]), double(last[1]), double(last[2])};
}

/// Largest pressure of each segment.
Pressures pressure_limits_kpa(const ArmDescription& arm);

/// The frame rule: a straight motion in pressure takes the fewest frames in which no segment moves
/// faster than the arm's rate limit, ⌈max |Δp| / step⌉, at least one.
/// @param step_limit_kpa  largest change of a pressure in one frame, > 0
int motion_frame_count(const PressuresRef& from_kpa, const PressuresRef& to_kpa,
                       double step_limit_kpa);

/// (2) of a straight motion: Σ|Δp|.
double motion_cost_kpa(const PressuresRef& from_kpa, const PressuresRef& to_kpa);

/// Runs straight motions in pressure through the forward model, frame by frame, and checks them for
/// collision. Counts model queries. Threads: one simulator, one thread.
class MotionSimulator {
 public:
  /// Everything is borrowed.
  MotionSimulator(const ArmDescription& arm, const ForwardModel& model,
                  const CollisionChecker& checker);

  /// Moves from (from_kpa, from) to to_kpa. Returns false at the first frame that collides, or that
  /// is reached through a collision; `end` (m×3) is then the frame's.
  [[nodiscard]] bool move(const PressuresRef& from_kpa, const BackboneRef& from,
                          const PressuresRef& to_kpa, Eigen::Ref<Backbone> end);

  /// The same without looking at obstacles.
  void move_unchecked(const PressuresRef& from_kpa, const BackboneRef& from,
                      const PressuresRef& to_kpa, Eigen::Ref<Backbone> end);

  /// Holds the pressures for `frames` frames; otherwise as `move`.
  [[nodiscard]] bool hold(const PressuresRef& kpa, const BackboneRef& from, int frames,
                          Eigen::Ref<Backbone> end);

  /// Appends the frames of a motion to `frames`, which holds at least its start.
  void append_motion(const PressuresRef& to_kpa, std::vector<PlanFrame>& frames);
  /// Appends `count` frames of holding.
  void append_hold(int count, std::vector<PlanFrame>& frames);

  const CollisionChecker& checker() const { return checker_; }
  const ArmDescription& arm() const { return arm_; }
  const ForwardModel& model() const { return model_; }
  std::uint64_t queries() const { return queries_; }
  void count_queries(std::uint64_t queries) { queries_ += queries; }

 private:
  void step(const PressuresRef& previous_kpa, const PressuresRef& current_kpa,
            const BackboneRef& previous, Eigen::Ref<Backbone> next);

  const ArmDescription& arm_;
  const ForwardModel& model_;
  const CollisionChecker& checker_;
  ForwardModel::Workspace workspace_;
  std::uint64_t queries_ = 0;
  Pressures previous_kpa_;
  Pressures current_kpa_;
  Backbone previous_;
  Backbone current_;
};

/// Straight motions simulated side by side without looking at obstacles, with every frame kept.
/// Threads: as MotionSimulator.
class MotionBatch {
 public:
  /// Borrows the simulator, and counts its queries there.
  explicit MotionBatch(MotionSimulator& simulator)
      : simulator_(simulator), rollouts_(simulator.model()) {}

  /// @param from_kpa   n×k, states' pressures, one a column
  /// @param from       3m×k, their backbones in row order
  /// @param to_kpa     n×k, where each goes
  void run(const Eigen::Ref<const Eigen::MatrixXf>& from_kpa,
           const Eigen::Ref<const Eigen::MatrixXf>& from,
           const Eigen::Ref<const Eigen::MatrixXf>& to_kpa);

  int frame_count(int motion) const {
    return static_cast<int>(frames_[static_cast<std::size_t>(motion)].cols()) - 1;
  }
  /// Backbone of `motion` after frame k, 0 ≤ k ≤ frame_count.
  Eigen::Map<const Backbone> frame(int motion, int k) const;
  bool is_free(int motion, const CollisionChecker& checker) const;

 private:
  MotionSimulator& simulator_;
  RolloutBatch rollouts_;
  std::vector<Eigen::MatrixXf> frames_;  // one a motion, 3m × (frames + 1)
};

}  // namespace limber
