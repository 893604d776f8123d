#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/data/simple_model.hpp"

namespace limber {

/// Which fit predicts a frame: none that it was fitted to.
class Folds {
 public:
  /// @param elsewhere  the fit comes from another recording: one fold
  Folds(const std::vector<Episode>& episodes, bool elsewhere);

  int count() const { return count_; }
  int of(int episode, int frame) const;
  /// The episodes, or pieces of a single one, that fold `fold` is fitted to.
  std::vector<Episode> training(const std::vector<Episode>& episodes, int fold) const;

 private:
  bool single_ = false;
  int frames_ = 0;  // of a single episode
  int count_ = 1;
};

/// What B_t − B_{t−1} is fitted to: both commands over their limits, the backbone before, and a 1.
Eigen::VectorXd step_terms(const ArmDescription& arm, const Episode& episode, int t,
                           const Eigen::VectorXd& before);

/// B_t − B_{t−1} from step_terms, by damped least squares: 3m×(2n + 3m + 1).
Eigen::MatrixXd fit_linear_step(const ArmDescription& arm, const std::vector<Episode>& episodes);

}  // namespace limber
