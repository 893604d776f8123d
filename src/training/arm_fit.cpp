#include "limber/training/arm_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>

#include "kernels/job_arena.hpp"
#include "learnt_kind.hpp"
#include "limber/arm/damped_solve.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/arm_offsets.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr int kFitWindowFrames = 64;  // that are predicted without correction
constexpr int kStarts = 32;           // of the family's arms
constexpr int kGoneOnFrom = 4;  // of those and the middle, the best: the cost has several minima
constexpr int kMaxIterations = 12;
constexpr double kMinGain = 1e-3;      // of the cost, relative: less is the end
constexpr double kLostM = 1.0;         // of a prediction that is no number
constexpr double kLeastErrorM = 1e-3;  // no network predicts better: a fit is never surer
constexpr double kFirstDamping = 1e-3;
constexpr double kMaxDamping = 1e6;
constexpr int kMinRestFrames = 20;

/// What a fit asks of predictions: plates' places beside the recorded ones, in a fixed order.
class Windows {
 public:
  Windows(const ArmDescription& arm, const CompensationModel& family,
          const std::vector<Episode>& episodes, int jobs)
      : arm_(arm),
        family_(family_of(family)),
        episodes_(episodes),
        pieces_(pieces_of_length(episodes, kFitWindowFrames)),
        jobs_(jobs),
        frames_(measured_frames(episodes, pieces_)) {
    refuse_if(frames_ == 0,
              "{} episodes hold no window in which the arm was tracked: there is nothing to fit to",
              episodes.size());
  }

  int size() const { return family_.family->size(); }
  Eigen::Index plates() const { return arm_.point_count() - 1; }
  int numbers() const { return position_size(arm_.dimension); }
  const CompensationModel& family() const { return family_; }

  CompensationModel model_of(const Eigen::VectorXf& e) const {
    return model_of_arm(family_, {"", e, Eigen::MatrixXf::Identity(size(), size())});
  }

  /// Offsets in x and y, in space z, of all plates but the base, frame by frame: 2 or 3 × (plates ·
  /// frames).
  Eigen::MatrixXf offsets(const Eigen::VectorXf& e) const {
    throw_if_interrupted();
    const std::vector<FrameMatrix> predicted =
        roll_out(ForwardModel(arm_, model_of(e)), episodes_, pieces_, jobs_, OnInterrupt::stop);
    Eigen::MatrixXf result(numbers(), plates() * frames_);
    Eigen::Index column = 0;
    for (const RolloutPiece& piece : pieces_) {
      const auto index = std::size_t(piece.episode);
      for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
        if (episodes_[index].was_tracked(t)) {
          result.middleCols(column, plates()) =
              (places_at(predicted[index], t, arm_.dimension) -
               places_at(episodes_[index].backbone, t, arm_.dimension))
                  .bottomRows(plates())
                  .transpose();
          column += plates();
        }
      }
    }
    return result.array().isFinite().select(result, float(kLostM));
  }

 private:
  const ArmDescription& arm_;
  CompensationModel family_;
  const std::vector<Episode>& episodes_;
  std::vector<RolloutPiece> pieces_;
  int jobs_;
  Eigen::Index frames_;
};

/// The cost of e given what was recorded, and its minimum's neighbourhood.
class Fit {
 public:
  Fit(const Windows& windows, Eigen::VectorXf e)
      : windows_(&windows), e_(std::move(e)), offsets_(windows.offsets(e_)) {}

  const Eigen::VectorXf& e() const { return e_; }
  double cost() const { return cost_of(e_, offsets_); }
  /// With fits from other starts: their costs are measured by errors of their own.
  double comparable_cost() const { return offsets_.colwise().norm().mean(); }

  /// One step downhill. False where there is none, or hardly any.
  bool improve() {
    scale_m_ = mean_length_m();
    linearise();
    const double before = cost();
    for (double damping = damping_; damping < kMaxDamping; damping *= 10.0) {
      const Eigen::VectorXf next =
          e_ - damped_solve(precision_, gradient_, damping * precision_.trace() / windows_->size())
                   .cast<float>();
      Eigen::MatrixXf offsets = windows_->offsets(next);
      const double after = cost_of(next, offsets);
      if (after < before) {
        e_ = next;
        offsets_ = std::move(offsets);
        damping_ = std::max(0.1 * damping, 1e-6);
        return after < before * (1.0 - kMinGain);
      }
    }
    return false;
  }

  /// Of e, where it has ended.
  Eigen::MatrixXf covariance() {
    scale_m_ = mean_length_m();
    linearise();
    return precision_.ldlt()
        .solve(Eigen::MatrixXd::Identity(windows_->size(), windows_->size()))
        .cast<float>();
  }

  /// ArmFit::expected_error_m. @pre covariance() was asked last
  double expected_error_m(const Eigen::MatrixXf& covariance) const {
    const Eigen::Index plates = windows_->plates();
    const Eigen::Index numbers = windows_->numbers();
    const Eigen::Index frames = offsets_.cols() / plates;
    double left_m = 0.0;
    double variance_m2 = 0.0;
    for (Eigen::Index frame = 0; frame < frames; ++frame) {
      const Eigen::Index tip = (frame + 1) * plates - 1;
      const auto slope = slope_.middleRows(numbers * tip, numbers);
      left_m += double(offsets_.col(tip).norm());
      variance_m2 += double((slope * covariance).cwiseProduct(slope).sum());
    }
    const auto count = double(frames);
    return std::hypot(left_m / count, std::sqrt(variance_m2 / count));
  }

 private:
  double share() const { return offset_share(scale_m_, windows_->plates()); }

  double cost_of(const Eigen::VectorXf& e, const Eigen::MatrixXf& offsets) const {
    const Eigen::ArrayXd length = offsets.colwise().norm().cast<double>();
    const double sum =
        (length < kSquareUpToM)
            .select(0.5 * length.square() / kSquareUpToM, length - 0.5 * kSquareUpToM)
            .sum();
    return share() * sum + 0.5 * double(e.squaredNorm());
  }

  double mean_length_m() const {
    return std::max(double(offsets_.colwise().norm().mean()), kLeastErrorM);
  }

  void linearise() {
    const int size = windows_->size();
    const Eigen::Index numbers = offsets_.size();
    slope_.resize(numbers, size);
    for (int i = 0; i < size; ++i) {
      const Eigen::VectorXf shifted = e_ + kArmStep * Eigen::VectorXf::Unit(size, i);
      slope_.col(i) = (windows_->offsets(shifted) - offsets_).reshaped() / kArmStep;
    }
    const Eigen::ArrayXf length = offsets_.colwise().norm();
    const Eigen::MatrixXf weighted =
        offset_weights(length, share(), windows_->numbers()).asDiagonal() * slope_;
    precision_ =
        (slope_.transpose() * weighted).cast<double>() + Eigen::MatrixXd::Identity(size, size);
    gradient_ = (weighted.transpose() * offsets_.reshaped() + e_).cast<double>();
  }

  const Windows* windows_;
  Eigen::VectorXf e_;
  Eigen::MatrixXf offsets_;
  double scale_m_ = kLeastErrorM;  // mean error: what an error is measured by
  double damping_ = kFirstDamping;
  Eigen::MatrixXf slope_;  // of the offsets, in e
  Eigen::MatrixXd precision_;
  Eigen::VectorXd gradient_;
};

/// The lowest minimum that is found from the best of the family's middle and some of its arms.
Fit best_fit(const Windows& windows) {
  const Eigen::MatrixXf& arms = windows.family().family->arms;
  std::vector<std::pair<float, Eigen::VectorXf>> starts;
  const auto add = [&](const Eigen::VectorXf& e) {
    starts.emplace_back(windows.offsets(e).colwise().norm().mean(), e);
  };
  add(Eigen::VectorXf::Zero(windows.size()));
  const Eigen::Index stride = std::max<Eigen::Index>(arms.cols() / kStarts, 1);
  for (Eigen::Index arm = 0; arm < arms.cols(); arm += stride) {
    add(arms.col(arm));
  }
  std::ranges::stable_sort(starts, {}, &std::pair<float, Eigen::VectorXf>::first);
  starts.resize(std::min<std::size_t>(starts.size(), kGoneOnFrom));
  std::optional<Fit> best;
  for (auto& [error, e] : starts) {
    Fit fit(windows, std::move(e));
    for (int k = 0; k < kMaxIterations && fit.improve(); ++k) {
    }
    if (!best || fit.comparable_cost() < best->comparable_cost()) {
      best.emplace(std::move(fit));
    }
  }
  return std::move(*best);
}

/// An episode of one arm, cut in two.
struct FitAndRest {
  std::vector<Episode> first;  ///< what is fitted to
  std::vector<Episode> rest;   ///< what the fit is judged by
};

std::optional<FitAndRest> cut_for_fit(const Episode& episode) {
  const int seen = std::min(kFitFrames, episode.frame_count() / 2);
  if (seen < kMinRestFrames) {
    return std::nullopt;
  }
  FitAndRest parts{{slice(episode, 0, seen)}, {slice(episode, seen, episode.frame_count() - seen)}};
  const auto tells = [](const std::vector<Episode>& part, int frames) {
    return measured_frames(part, pieces_of_length(part, frames)) > 0;
  };
  if (!tells(parts.first, kFitWindowFrames) || !tells(parts.rest, kValidationFrames)) {
    return std::nullopt;
  }
  return parts;
}

}  // namespace

ArmFit fit_arm(const ArmDescription& arm, const CompensationModel& family,
               const std::vector<Episode>& episodes, int jobs) {
  require_family(family, "the family");
  require_model_of(family, arm, "the family");
  require_kind_learnt(family, episodes);
  require_episodes_of(episodes, arm);
  const Windows windows(arm, family, episodes, jobs);
  Fit fit = best_fit(windows);
  ArmFit result;
  const Eigen::MatrixXf covariance = fit.covariance();
  result.expected_error_m = fit.expected_error_m(covariance);
  result.model = model_of_arm(family, {"", fit.e(), covariance});
  const float root = std::sqrt(float(windows.size()));
  result.distance = result.model.member_of_family->distance();
  result.distance_to_nearest = double(
      (windows.family().family->arms.colwise() - fit.e()).colwise().norm().minCoeff() / root);
  return result;
}

bool can_be_fitted_to(const std::vector<Episode>& episodes) {
  return measured_frames(episodes, pieces_of_length(episodes, kFitWindowFrames)) > 0;
}

bool tells_of_other_arms(const std::vector<Episode>& episodes) {
  return std::ranges::any_of(
      episodes, [](const Episode& episode) { return cut_for_fit(episode).has_value(); });
}

double error_on_other_arms_m(const ArmDescription& arm, const CompensationModel& model,
                             const std::vector<Episode>& episodes, int jobs) {
  std::vector<double> errors(episodes.size(), std::numeric_limits<double>::quiet_NaN());
  const std::atomic<bool>* const stop = stop_of_thread();
  JobArena arena(jobs);
  arena.for_each(episodes.size(), [&](std::size_t i) {
    const StopScope scope(stop);
    const std::optional<FitAndRest> parts = cut_for_fit(episodes[i]);
    if (!parts) {
      return;
    }
    const ForwardModel forward(
        arm, is_family(model) ? fit_arm(arm, model, parts->first, 1).model : model);
    const double error_m = tip_error_m(forward, parts->rest, kValidationFrames, 1);
    errors[i] = std::isnan(error_m) ? std::numeric_limits<double>::infinity() : error_m;  // ran off
  });
  std::erase_if(errors, [](double error) { return std::isnan(error); });
  return errors.empty() ? std::numeric_limits<double>::quiet_NaN() : mean(errors);
}

}  // namespace limber
