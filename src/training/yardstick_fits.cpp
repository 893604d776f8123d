#include "yardstick_fits.hpp"

#include <algorithm>

#include "limber/arm/damped_solve.hpp"
#include "limber/data/episode_slice.hpp"

namespace limber {

namespace {

constexpr int kYardstickFolds = 5;
constexpr double kRidge = 1e-6;  // of the mean square of the terms: neighbouring plates are alike

/// XᵀX and XᵀY, of which the coefficients come.
struct NormalEquations {
  Eigen::MatrixXd square;
  Eigen::MatrixXd product;

  NormalEquations(Eigen::Index terms, Eigen::Index answers)
      : square(Eigen::MatrixXd::Zero(terms, terms)),
        product(Eigen::MatrixXd::Zero(terms, answers)) {}

  void add(const Eigen::VectorXd& terms, const Eigen::VectorXd& answer) {
    square.selfadjointView<Eigen::Lower>().rankUpdate(terms);
    product.noalias() += terms * answer.transpose();
  }

  Eigen::MatrixXd solved() const {
    const double damping = kRidge * (square.trace() / double(square.rows()) + 1.0);
    return damped_solve(square, product, damping).transpose();
  }
};

}  // namespace

Folds::Folds(const std::vector<Episode>& episodes, bool elsewhere)
    : single_(episodes.size() == 1),
      frames_(episodes.front().frame_count()),
      count_(elsewhere ? 1
             : single_ ? kYardstickFolds
                       : std::min(kYardstickFolds, int(episodes.size()))) {}

int Folds::of(int episode, int frame) const {
  if (count_ == 1) {
    return 0;
  }
  return single_ ? static_cast<int>(std::int64_t(frame) * count_ / frames_) : episode % count_;
}

std::vector<Episode> Folds::training(const std::vector<Episode>& episodes, int fold) const {
  std::vector<Episode> others;
  if (count_ == 1) {
    return episodes;
  }
  if (!single_) {
    for (std::size_t e = 0; e < episodes.size(); ++e) {
      if (of(static_cast<int>(e), 0) != fold) {
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

Eigen::VectorXd command_terms(const ArmDescription& arm, const Episode& episode, int t) {
  const Eigen::Index n = arm.segment_count();
  Eigen::VectorXd terms(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    terms[i] = double(episode.pressure_kpa(t, i)) /
               arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa.largest_kpa();
  }
  terms[n] = 1.0;
  return terms;
}

Eigen::VectorXd step_terms(const ArmDescription& arm, const Episode& episode, int t,
                           const Eigen::VectorXd& before) {
  const Eigen::Index n = arm.segment_count();
  Eigen::VectorXd terms(2 * n + before.size() + 1);
  terms << command_terms(arm, episode, t - 1).head(n), command_terms(arm, episode, t).head(n),
      before, 1.0;
  return terms;
}

LinearModels fit_linear(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  const Eigen::Index n = arm.segment_count();
  const Eigen::Index size = kPoseSize * arm.point_count();
  NormalEquations of_commands(n + 1, size);
  NormalEquations of_a_step(2 * n + size + 1, size);
  for (const Episode& episode : episodes) {
    for (int t = 0; t < episode.frame_count(); ++t) {
      if (!episode.was_tracked(t)) {
        continue;
      }
      const Eigen::VectorXd now = episode.backbone.row(t).transpose().cast<double>();
      of_commands.add(command_terms(arm, episode, t), now);
      if (t > 0 && episode.was_tracked(t - 1)) {
        const Eigen::VectorXd before = episode.backbone.row(t - 1).transpose().cast<double>();
        of_a_step.add(step_terms(arm, episode, t, before), now - before);
      }
    }
  }
  return {of_commands.solved(), of_a_step.solved()};
}

}  // namespace limber
