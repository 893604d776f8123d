#include "limber/training/yardsticks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/damped_solve.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr std::int64_t kMinFitFrames = 200;  // tracked: fewer tell a fit nothing
constexpr double kRunAway = 100.0;  // [m] or [rad]: a linear step that got there stays there
constexpr int kYardstickFolds = 5;
constexpr double kRidge = 1e-6;  // of the mean square of the terms: neighbouring plates are alike

double mean_of_known(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values.empty() ? std::nan("") : mean(values);
}

std::vector<double> episode_means(const std::vector<FrameMatrix>& predicted,
                                  const std::vector<Episode>& episodes) {
  return mapped<double>(episodes.size(), [&](std::size_t e) {
    return mean_of_known(tip_errors(predicted[e], episodes[e]).position_cm);
  });
}

/// Each over its segment's limit.
Eigen::VectorXd command_terms(const ArmDescription& arm, const Episode& episode, int t) {
  Eigen::VectorXd terms(arm.channel_count());
  for (Eigen::Index i = 0; i < terms.size(); ++i) {
    terms[i] = double(episode.pressure_kpa(t, i)) / arm.limits_of_channel(int(i)).largest_kpa();
  }
  return terms;
}

/// What B_t − B_{t−1} is fitted to: both commands over their limits, the backbone before, and a 1.
Eigen::VectorXd step_terms(const ArmDescription& arm, const Episode& episode, int t,
                           const Eigen::VectorXd& before) {
  Eigen::VectorXd terms(2 * arm.channel_count() + before.size() + 1);
  terms << command_terms(arm, episode, t - 1), command_terms(arm, episode, t), before, 1.0;
  return terms;
}

/// B_t − B_{t−1} from step_terms, by damped least squares: 3m×(2n + 3m + 1).
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

/// Everything that is fitted, one for each fold.
struct Fits {
  Folds folds;
  std::vector<Eigen::MatrixXd> linear;
  std::vector<std::vector<FrameMatrix>> simple;  // predictions of every episode by every fold

  std::size_t of(const RolloutPiece& piece, int t) const {
    return std::size_t(folds.of(piece.episode, t));
  }
};

template <class Model>
std::vector<FrameMatrix> predict_all(const Model& model, const ArmDescription& arm,
                                     const std::vector<Episode>& episodes) {
  return mapped<FrameMatrix>(episodes,
                             [&](const Episode& episode) { return predict(model, arm, episode); });
}

Fits fit_all(const ArmDescription& arm, const std::vector<Episode>& episodes,
             const std::vector<Episode>& fit_to) {
  Fits fits{Folds(episodes, !fit_to.empty()), {}, {}};
  for (int fold = 0; fold < fits.folds.count(); ++fold) {
    throw_if_interrupted();
    const std::vector<Episode> training =
        fit_to.empty() ? fits.folds.training(episodes, fold) : fit_to;
    fits.linear.push_back(fit_linear_step(arm, training));
    fits.simple.push_back(arm.is_spatial()
                              ? predict_all(fit_space_model(arm, training), arm, episodes)
                              : predict_all(fit_simple_model(arm, training).model, arm, episodes));
  }
  return fits;
}

/// 1, 2, 4, … and the longest episode.
std::vector<int> horizons_of(const std::vector<Episode>& episodes) {
  int longest = 1;
  for (const Episode& episode : episodes) {
    longest = std::max(longest, episode.frame_count() - 1);
  }
  std::vector<int> horizons;
  for (int frames = 1; frames < longest; frames *= 2) {
    horizons.push_back(frames);
  }
  horizons.push_back(longest);
  return horizons;
}

class Measurement {
 public:
  /// @param curves  that will be added
  /// @param note    told the share that is done after each horizon of a curve; may be empty
  Measurement(const std::vector<Episode>& episodes, YardstickReport& report, int curves,
              const std::function<void(double)>& note)
      : episodes_(episodes), report_(report), note_(note) {
    report_.horizon_frames = horizons_of(episodes);
    steps_ = curves * int(report_.horizon_frames.size());
  }

  void add(const char* key, const char* label, const PiecePrediction& predict_piece) {
    add_curve_of(key, label, predict_piece);
    report_.predictors.back().errors = errors_at_every_restart(episodes_, [&](Restart restart) {
      return predict_pieces(predict_piece, episodes_, pieces_for(episodes_, restart));
    });
  }

  void add_curve_of(const char* key, const char* label, const PiecePrediction& predict_piece) {
    add_curve(key, label, [&](const std::vector<RolloutPiece>& pieces) {
      return predict_pieces(predict_piece, episodes_, pieces);
    });
  }

  void add_model(const char* key, const char* label, const ForwardModel& model, int jobs) {
    add_curve(key, label, [&](const std::vector<RolloutPiece>& pieces) {
      return roll_out(model, episodes_, pieces, jobs, OnInterrupt::stop);
    });
  }

 private:
  template <class PredictAll>
  void add_curve(const char* key, const char* label, const PredictAll& predict_all) {
    PredictorErrors errors{key, label, std::nullopt, {}, {}};
    for (const int frames : report_.horizon_frames) {
      const std::vector<FrameMatrix> predicted = predict_all(pieces_of_length(episodes_, frames));
      errors.tip_cm.push_back(mean_of_known(errors_over(predicted, episodes_).position_cm));
      if (frames == report_.horizon_frames.back()) {
        errors.episode_cm = episode_means(predicted, episodes_);
      }
      ++done_;
      if (note_) {
        note_(double(done_) / double(steps_));
      }
    }
    report_.predictors.push_back(std::move(errors));
  }

  const std::vector<Episode>& episodes_;
  YardstickReport& report_;
  const std::function<void(double)>& note_;
  int steps_ = 0;
  int done_ = 0;
};

std::string fitted_to_words(const std::vector<Episode>& episodes,
                            const std::vector<Episode>& fit_to) {
  if (!fit_to.empty()) {
    return fmt::format("{} other episodes", fit_to.size());
  }
  const int folds = Folds(episodes, false).count();
  return episodes.size() == 1
             ? fmt::format("this recording, each fifth predicted by a fit to the other {}",
                           folds - 1)
             : fmt::format(
                   "this recording, its episodes in {} parts, "
                   "each predicted by a fit to the others",
                   folds);
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

YardstickReport measure_yardsticks(const ArmDescription& arm, const ForwardModel& no_load,
                                   const ForwardModel* network,
                                   const std::vector<Episode>& episodes,
                                   const std::vector<Episode>& fit_to, int jobs,
                                   const std::function<void(double)>& note) {
  require_episodes_of(episodes, arm);
  require_episodes_of(fit_to, arm, "training data");
  YardstickReport report;
  for (const Episode& episode : episodes) {
    report.episode_names.push_back(episode_name(std::ssize(report.episode_names), episode.log));
  }
  Measurement measurement(episodes, report, network != nullptr ? 6 : 5, note);
  measurement.add_model("no_load", "no load", no_load, jobs);
  if (network != nullptr) {
    measurement.add_model("network", "network", *network, jobs);
  }
  measurement.add("hold", "hold the pose", hold);
  measurement.add("constant_velocity", "constant velocity", keep_velocity);
  if (tracked_count(fit_to.empty() ? episodes : fit_to) < kMinFitFrames) {
    report.fitted_to = fmt::format("nothing: fewer than {} frames were tracked", kMinFitFrames);
    return report;
  }
  std::optional<Fits> fitted;
  try {
    fitted = fit_all(arm, episodes, fit_to);
  } catch (const InputError& too_little) {  // a part of them
    report.fitted_to = fmt::format("nothing: {}", too_little.what());
    return report;
  }
  const Fits& fits = *fitted;
  report.fitted_to = fitted_to_words(episodes, fit_to);
  measurement.add("linear_one_step", "linear step, run freely",
                  [&](const Episode& episode, const RolloutPiece& piece, FrameMatrix& predicted) {
                    Eigen::VectorXd state =
                        episode.backbone.row(piece.first).transpose().cast<double>();
                    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
                      state += fits.linear[fits.of(piece, t)] * step_terms(arm, episode, t, state);
                      state = state.cwiseMax(-kRunAway).cwiseMin(kRunAway);
                      predicted.row(t) = state.transpose().cast<float>();
                    }
                  });
  measurement.add("simple_model", "fitted simple model",
                  [&](const Episode&, const RolloutPiece& piece, FrameMatrix& predicted) {
                    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
                      const auto& of_fold = fits.simple[fits.of(piece, t)];
                      predicted.row(t) = of_fold[piece.episode].row(t);
                    }
                  });
  return report;
}

YardstickReport measure_horizons(const ForwardModel& no_load, const ForwardModel* network,
                                 const std::vector<Episode>& episodes, int jobs,
                                 const std::function<void(double)>& note) {
  require_episodes_of(episodes, no_load.no_load());
  YardstickReport report;
  Measurement measurement(episodes, report, network != nullptr ? 3 : 2, note);
  measurement.add_model("no_load", "no load", no_load, jobs);
  if (network != nullptr) {
    measurement.add_model("network", "network", *network, jobs);
  }
  measurement.add_curve_of("hold", "hold the pose", hold);
  return report;
}

bool learnt_from(const CompensationModel& model, const std::string& content_hash) {
  const auto found = model.training.find("data");
  return found != model.training.end() && found->second.find(content_hash) != std::string::npos;
}

}  // namespace limber
