#include "yardstick_fits.hpp"

#include <algorithm>

#include "limber/arm/damped_solve.hpp"
#include "limber/data/episode_slice.hpp"

namespace limber {

namespace {

constexpr int kYardstickFolds = 5;
constexpr double kRidge = 1e-6;  // of the mean square of the terms: neighbouring plates are alike

/// Each over its segment's limit.
Eigen::VectorXd command_terms(const ArmDescription& arm, const Episode& episode, int t) {
  Eigen::VectorXd terms(arm.channel_count());
  for (Eigen::Index i = 0; i < terms.size(); ++i) {
    terms[i] = double(episode.pressure_kpa(t, i)) / arm.limits_of_channel(int(i)).largest_kpa();
  }
  return terms;
}

}  // namespace

Folds::Folds(const std::vector<Episode>& episodes, bool elsewhere)
    : single_(episodes.size() == 1),
      frames_(episodes.front().frame_count()),
      count_(elsewhere ? 1
             : single_ ? kYardstickFolds
                       : std::min(kYardstickFolds, int(episodes.size()))) {}

int Folds::of(int episode, int frame) const {
  return single_ ? int(std::int64_t(frame) * count_ / frames_) : episode % count_;
}

std::vector<Episode> Folds::training(const std::vector<Episode>& episodes, int fold) const {
  std::vector<Episode> others;
  if (!single_) {
    for (std::size_t e = 0; e < episodes.size(); ++e) {
      if (of(int(e), 0) != fold) {
        others.push_back(episodes[e]);
      }
    }
    return others;
  }
  int first = 0;
  for (int t = 1; t <= frames_; ++t) {
    if (t == frames_ || of(0, t) != of(0, first)) {
      if (of(0, first) != fold) {
        others.push_back(slice(episodes.front(), first, t - first));
      }
      first = t;
    }
  }
  return others;
}

Eigen::VectorXd step_terms(const ArmDescription& arm, const Episode& episode, int t,
                           const Eigen::VectorXd& before) {
  Eigen::VectorXd terms(2 * arm.channel_count() + before.size() + 1);
  terms << command_terms(arm, episode, t - 1), command_terms(arm, episode, t), before, 1.0;
  return terms;
}

Eigen::MatrixXd fit_linear_step(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  const Eigen::Index size = pose_size(arm.dimension) * arm.point_count();
  const Eigen::Index count = 2 * arm.channel_count() + size + 1;
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(count, count);  // XᵀX
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(count, size);  // XᵀY
  for (const Episode& episode : episodes) {
    for (int t = 1; t < episode.frame_count(); ++t) {
      if (episode.was_tracked(t) && episode.was_tracked(t - 1)) {
        const Eigen::VectorXd now = episode.backbone.row(t).transpose().cast<double>();
        const Eigen::VectorXd before = episode.backbone.row(t - 1).transpose().cast<double>();
        const Eigen::VectorXd terms = step_terms(arm, episode, t, before);
        square.selfadjointView<Eigen::Lower>().rankUpdate(terms);
        product.noalias() += terms * (now - before).transpose();
      }
    }
  }
  const double damping = kRidge * (square.trace() / double(count) + 1.0);
  return damped_solve(square, product, damping).transpose();
}

}  // namespace limber
