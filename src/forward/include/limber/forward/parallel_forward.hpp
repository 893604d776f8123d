#pragma once
// For those who ask a model where the arm goes.

#include <memory>

#include <Eigen/Core>

#include "limber/forward/forward_model.hpp"

namespace limber {

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
