#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/forward/forward_model.hpp"

namespace limber {

/// Set points of frame k of a straight motion of `count` frames, 1 ≤ k ≤ count, in equal steps,
/// written to `setpoint_kpa`; the last is exactly `to_kpa`. Sizes n.
void motion_setpoint(const Eigen::Ref<const Pressures>& from_kpa,
                     const Eigen::Ref<const Pressures>& to_kpa, int k, int count,
                     Eigen::Ref<Pressures> setpoint_kpa);

/// Straight motions in pressure, each of its own length, simulated side by side: one step moves all
/// of them by a frame in one batch. A motion that has ended, or that nobody wants to go on with, is
/// removed, and the last column takes its place, so that every batch is full of work.
///
/// A motion's backbones are to the bit those of ForwardModel::step, whatever runs beside it.
/// Threads: one batch, one thread. Borrows the model. Allocates where it grows beyond its largest
/// size so far.
class RolloutBatch {
 public:
  explicit RolloutBatch(const ForwardModel& model);

  /// Adds a motion from (from_kpa, from) to to_kpa in `frames` ≥ 1 frames (motion_setpoint).
  /// Sizes n, m×3, n; numbers finite. `label` is the caller's.
  void add(int label, const Eigen::Ref<const Pressures>& from_kpa,
           const Eigen::Ref<const Backbone>& from, const Eigen::Ref<const Pressures>& to_kpa,
           int frames);

  /// Motions in progress; they are in columns 0 … size() − 1.
  int size() const { return static_cast<int>(motions_.size()); }
  /// One frame on. @pre no motion has ended.
  void step();

  int label(int column) const { return motion(column).label; }
  /// Frames simulated so far.
  int frame(int column) const { return motion(column).frame; }
  bool has_ended(int column) const { return motion(column).frame == motion(column).frames; }
  /// Backbones one frame ago and now. @pre frame ≥ 1 for `before`
  Eigen::Map<const Backbone> before(int column) const;
  Eigen::Map<const Backbone> now(int column) const;

  /// Ends a motion; the last column is then this one.
  void remove(int column);
  void clear() { motions_.clear(); }

 private:
  struct Motion {
    int label;
    int frame;
    int frames;
  };

  const Motion& motion(int column) const { return motions_[static_cast<std::size_t>(column)]; }
  void grow();

  const ForwardModel& model_;
  ForwardModel::Workspace workspace_;
  std::vector<Motion> motions_;
  Eigen::MatrixXf from_kpa_;  // n × capacity, as the next ones
  Eigen::MatrixXf to_kpa_;
  Eigen::MatrixXf before_kpa_;
  Eigen::MatrixXf now_kpa_;
  Eigen::MatrixXf before_;  // 3m × capacity
  Eigen::MatrixXf now_;
};

}  // namespace limber
