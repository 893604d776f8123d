#pragma once
// For those who ask a model where the arm goes.

#include <vector>

#include "limber/forward/forward_model.hpp"

namespace limber {

/// Mean and spread of an ensemble's predictions: networks trained together, each from its own
/// initial weights. Each member carries its own backbone, so members that have drifted apart stay
/// apart, and the spread grows along a rollout as the uncertainty does. Where a pure function of
/// one backbone is needed (planning, execution), ForwardModel on the same file is the member with
/// the smallest validation error.
///
/// Sizes: N members, n channels, m backbone points; of an arm in space read 7m for 3m.
/// Threads: constant after construction.
class EnsembleForward {
 public:
  /// @throws InputError as ForwardModel.
  EnsembleForward(const ArmDescription& arm, const CompensationModel& model);

  int member_count() const { return int(members_.size()); }
  const ForwardModel& member(int index) const { return members_[index]; }

  /// Of a rollout: 3m×(T + 1) each. The standard deviation is the members' own (divided by N), of
  /// each number: 0 for a single network, and 0 in the given first column. Mean rotations in space
  /// are unit quaternions.
  struct Prediction {
    Eigen::MatrixXf mean;
    Eigen::MatrixXf standard_deviation;
  };

  /// Feeds every member's own output back along a motion: pressures n×(T + 1), `first` 3m numbers
  /// in row order. @throws InputError if a size is wrong or a number not finite.
  Prediction rollout(const Eigen::Ref<const Eigen::MatrixXf>& pressures_kpa,
                     const Eigen::Ref<const Eigen::VectorXf>& first) const;

 private:
  std::vector<ForwardModel> members_;
};

/// Mean and standard deviation, number by number, of N ≥ 1 matrices of one size: in space of poses
/// whose quaternions have one sign, as those have that are chained from a common base.
EnsembleForward::Prediction mean_and_deviation(const std::vector<Eigen::MatrixXf>& members,
                                               Dimension dimension = Dimension::plane);

}  // namespace limber
