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

/// B_t from (q_t), and B_t − B_{t−1} from (q_{t−1}, q_t, B_{t−1}): least squares with a constant.
struct LinearModels {
  Eigen::MatrixXd of_commands;  ///< 3m×(n + 1)
  Eigen::MatrixXd of_a_step;    ///< 3m×(2n + 3m + 1)
};

/// Commands over their limits and, where there is one, the backbone before; a 1 at the end.
Eigen::VectorXd command_terms(const ArmDescription& arm, const Episode& episode, int t);
Eigen::VectorXd step_terms(const ArmDescription& arm, const Episode& episode, int t,
                           const Eigen::VectorXd& before);

LinearModels fit_linear(const ArmDescription& arm, const std::vector<Episode>& episodes);

}  // namespace limber
