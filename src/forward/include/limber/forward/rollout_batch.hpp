#pragma once
// For those who ask a model where the arm goes.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limber/forward/forward_model.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

/// Motions along straight lines of set points, each of its own length, simulated side by side
/// through valves and forward model: one step moves all of them by a frame in one batch. A motion
/// that has ended, or is no longer wanted, is removed, and the last column takes its place, so that
/// every column of a batch does useful work.
///
/// A motion's states equal those of MotionModel::step to the bit, whatever runs beside it.
/// Threads: one batch, one thread. Borrows what the model borrows.
/// Allocates only when it grows beyond its largest size so far.
class RolloutBatch {
 public:
  explicit RolloutBatch(const MotionModel& model);

  /// Adds a motion from a state, that is from its last set points, to `to_kpa` in `frames` ≥ 1
  /// frames (motion_setpoint). Numbers finite. `label` is the caller's.
  void add(int label, const MotionState& from, const Eigen::Ref<const Pressures>& to_kpa,
           int frames);

  /// Motions in progress; they are in columns 0 … size() − 1.
  int size() const { return int(motions_.size()); }
  /// One frame on. @pre no motion has ended.
  void step();

  int label(int column) const { return motion(column).label; }
  /// Frames simulated so far.
  int frame(int column) const { return motion(column).frame; }
  bool has_ended(int column) const { return motion(column).frame == motion(column).frames; }
  /// Backbones one frame ago and now. @pre frame ≥ 1 for `before`
  Eigen::Map<const Backbone> before(int column) const;
  Eigen::Map<const Backbone> now(int column) const;
  /// Valve state now.
  Eigen::Map<const Eigen::VectorXf> valves(int column) const;
  MotionState state(int column) const;

  /// Begins the next motion in place of one, from where that has ended, under the same label.
  /// @pre has_ended(column), `frames` ≥ 1, numbers finite
  void go_on(int column, const Eigen::Ref<const Pressures>& to_kpa, int frames);
  /// Ends a motion; the last column is then this one.
  void remove(int column);
  void clear() { motions_.clear(); }

 private:
  struct Motion {
    int label;
    int frame;
    int frames;
  };

  const Motion& motion(int column) const { return motions_[column]; }
  void grow();

  MotionModel model_;
  MotionModel::Workspace workspace_;
  std::vector<Motion> motions_;
  Pressures setpoint_kpa_;
  Eigen::MatrixXf from_kpa_;  // n × capacity, set points, as the next one
  Eigen::MatrixXf to_kpa_;
  Eigen::MatrixXf before_kpa_;  // n × capacity, pressures, as the next one
  Eigen::MatrixXf now_kpa_;
  Eigen::MatrixXf valves_;   // valve states
  Eigen::MatrixXf earlier_;  // 3m × capacity, B_{t−2}; no rows where the model does not read it
  Eigen::MatrixXf before_;   // 3m × capacity
  Eigen::MatrixXf now_;
};

/// Large batches of a forward model, split over threads. The answers do not depend on how many
/// there are. Threads: one caller at a time.
class ParallelForward {
 public:
  /// @param jobs  threads to use, 0 for one per core.
  explicit ParallelForward(int jobs);
  ~ParallelForward();
  ParallelForward(ParallelForward&&) noexcept;
  ParallelForward& operator=(ParallelForward&&) noexcept;

  int jobs() const;

  /// ForwardModel::step_batch, in parts of some hundred queries.
  void step_batch(const ForwardModel& model, const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& before,
                  const Eigen::Ref<const Eigen::MatrixXf>& previous,
                  Eigen::Ref<Eigen::MatrixXf> next);
  void step_batch(const ForwardModel& model, const Eigen::Ref<const Eigen::MatrixXf>& previous_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& current_kpa,
                  const Eigen::Ref<const Eigen::MatrixXf>& previous,
                  Eigen::Ref<Eigen::MatrixXf> next);

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
};

}  // namespace limber
