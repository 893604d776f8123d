#include "limber/training/yardsticks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/statistics.hpp"
#include "limber/training/evaluation.hpp"
#include "rollout.hpp"
#include "yardstick_fits.hpp"

namespace limber {

namespace {

constexpr int kHorizonFrames = 32;
constexpr std::int64_t kMinFitFrames = 200;  // tracked: fewer tell a fit nothing
constexpr double kRunAway = 100.0;  // [m] or [rad]: a linear step that got there stays there

/// Predicts the frames of a piece from the recorded backbone at its start.
using PiecePrediction = std::function<void(const RolloutPiece&, FrameMatrix&)>;

std::vector<FrameMatrix> predict_pieces(const PiecePrediction& predict_piece,
                                        const std::vector<Episode>& episodes,
                                        const std::vector<RolloutPiece>& pieces) {
  std::vector<FrameMatrix> predicted;
  for (const Episode& episode : episodes) {
    predicted.push_back(FrameMatrix::Constant(episode.backbone.rows(), episode.backbone.cols(),
                                              std::numeric_limits<float>::quiet_NaN()));
  }
  for (const RolloutPiece& piece : pieces) {
    throw_if_interrupted();
    predict_piece(piece, predicted[static_cast<std::size_t>(piece.episode)]);
  }
  return predicted;
}

TipErrorSeries errors_of(const std::vector<FrameMatrix>& predicted,
                         const std::vector<Episode>& episodes) {
  TipErrorSeries all;
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    append(all, tip_errors(predicted[e], episodes[e], 1));
  }
  return all;
}

double mean_of_known(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values.empty() ? std::nan("") : mean(values);
}

std::vector<double> episode_means(const std::vector<FrameMatrix>& predicted,
                                  const std::vector<Episode>& episodes) {
  std::vector<double> means;
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    means.push_back(mean_of_known(tip_errors(predicted[e], episodes[e], 1).position_cm));
  }
  return means;
}

PiecePrediction hold_predictions(const std::vector<Episode>& episodes) {
  return [&](const RolloutPiece& piece, FrameMatrix& predicted) {
    const Episode& episode = episodes[static_cast<std::size_t>(piece.episode)];
    for (int k = 1; k <= piece.frames; ++k) {
      predicted.row(piece.first + k) = episode.backbone.row(piece.first);
    }
  };
}

/// Needs two tracked frames. Without them it holds the pose; a single
/// step then says nothing.
PiecePrediction constant_velocity_predictions(const std::vector<Episode>& episodes) {
  return [&](const RolloutPiece& piece, FrameMatrix& predicted) {
    const Episode& episode = episodes[static_cast<std::size_t>(piece.episode)];
    const bool known = piece.first > 0 && episode.was_tracked(piece.first - 1);
    if (!known && piece.frames == 1) {
      return;
    }
    const auto start = episode.backbone.row(piece.first);
    const Eigen::RowVectorXf step =
        known ? Eigen::RowVectorXf(start - episode.backbone.row(piece.first - 1))
              : Eigen::RowVectorXf::Zero(start.size());
    for (int k = 1; k <= piece.frames; ++k) {
      predicted.row(piece.first + k) = start + float(k) * step;
    }
  };
}

/// Everything that is fitted, one for each fold.
struct Fits {
  Folds folds;
  std::vector<LinearModels> linear;
  std::vector<std::vector<FrameMatrix>> simple;  // predictions of every episode by every fold

  int of(int episode, int t) const { return folds.of(episode, t); }
};

Fits fit_all(const ArmDescription& arm, const std::vector<Episode>& episodes,
             const std::vector<Episode>& fit_to) {
  Fits fits{Folds(episodes, !fit_to.empty()), {}, {}};
  for (int fold = 0; fold < fits.folds.count(); ++fold) {
    throw_if_interrupted();
    const std::vector<Episode> training =
        fit_to.empty() ? fits.folds.training(episodes, fold) : fit_to;
    fits.linear.push_back(fit_linear(arm, training));
    const SimpleModel simple = fit_simple_model(arm, training).model;
    std::vector<FrameMatrix>& predicted = fits.simple.emplace_back();
    for (const Episode& episode : episodes) {
      predicted.push_back(predict(simple, arm, episode));
    }
  }
  return fits;
}

PiecePrediction static_linear(const ArmDescription& arm, const std::vector<Episode>& episodes,
                              const Fits& fits) {
  return [&](const RolloutPiece& piece, FrameMatrix& predicted) {
    const Episode& episode = episodes[static_cast<std::size_t>(piece.episode)];
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      const auto fold = static_cast<std::size_t>(fits.of(piece.episode, t));
      const Eigen::VectorXd pose = fits.linear[fold].of_commands * command_terms(arm, episode, t);
      predicted.row(t) = pose.transpose().cast<float>();
    }
  };
}

PiecePrediction linear_one_step(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                const Fits& fits) {
  return [&](const RolloutPiece& piece, FrameMatrix& predicted) {
    const Episode& episode = episodes[static_cast<std::size_t>(piece.episode)];
    Eigen::VectorXd state = episode.backbone.row(piece.first).transpose().cast<double>();
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      const auto fold = static_cast<std::size_t>(fits.of(piece.episode, t));
      state += fits.linear[fold].of_a_step * step_terms(arm, episode, t, state);
      state = state.cwiseMax(-kRunAway).cwiseMin(kRunAway);
      predicted.row(t) = state.transpose().cast<float>();
    }
  };
}

PiecePrediction simple_model(const Fits& fits) {
  return [&](const RolloutPiece& piece, FrameMatrix& predicted) {
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      const auto fold = static_cast<std::size_t>(fits.of(piece.episode, t));
      predicted.row(t) = fits.simple[fold][static_cast<std::size_t>(piece.episode)].row(t);
    }
  };
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
  Measurement(const std::vector<Episode>& episodes, YardstickReport& report)
      : episodes_(episodes), report_(report) {
    report_.horizon_frames = horizons_of(episodes);
  }

  void add(const char* key, const char* label, const PiecePrediction& predict_piece) {
    const auto series = [&](const std::vector<RolloutPiece>& pieces) {
      return errors_of(predict_pieces(predict_piece, episodes_, pieces), episodes_);
    };
    const TipErrorSeries step = series(pieces_of_length(episodes_, 1));
    const int whole = std::numeric_limits<int>::max();
    report_.yardsticks.push_back({key,
                                  label,
                                  {summarise(step), summarise(moving_frames(step)),
                                   summarise(series(pieces_of_length(episodes_, kHorizonFrames))),
                                   summarise(series(pieces_of_motions(episodes_))),
                                   summarise(series(pieces_of_length(episodes_, whole)))}});
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
    PredictorCurve curve{key, label, {}, {}};
    for (const int frames : report_.horizon_frames) {
      const std::vector<FrameMatrix> predicted = predict_all(pieces_of_length(episodes_, frames));
      curve.tip_cm.push_back(mean_of_known(errors_of(predicted, episodes_).position_cm));
      if (frames == report_.horizon_frames.back()) {
        curve.episode_cm = episode_means(predicted, episodes_);
      }
    }
    report_.curves.push_back(std::move(curve));
  }

  const std::vector<Episode>& episodes_;
  YardstickReport& report_;
};

std::int64_t tracked_frames(const std::vector<Episode>& episodes) {
  std::int64_t frames = 0;
  for (const Episode& episode : episodes) {
    frames += episode.frame_count() - episode.untracked_count();
  }
  return frames;
}

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

YardstickReport measure_yardsticks(const ArmDescription& arm, const ForwardModel& no_load,
                                   const ForwardModel* network,
                                   const std::vector<Episode>& episodes,
                                   const std::vector<Episode>& fit_to, int jobs) {
  require_episodes_of(episodes, arm);
  require_episodes_of(fit_to, arm, "training data");
  YardstickReport report;
  for (const Episode& episode : episodes) {
    report.episode_names.push_back(episode_name(std::ssize(report.episode_names), episode.log));
  }
  Measurement measurement(episodes, report);
  measurement.add_model("no_load", "no load", no_load, jobs);
  if (network != nullptr) {
    measurement.add_model("network", "network", *network, jobs);
  }
  measurement.add("hold", "hold the pose", hold_predictions(episodes));
  measurement.add("constant_velocity", "constant velocity",
                  constant_velocity_predictions(episodes));
  if (tracked_frames(fit_to.empty() ? episodes : fit_to) < kMinFitFrames) {
    report.fitted_to = fmt::format("nothing: fewer than {} frames were tracked", kMinFitFrames);
    return report;
  }
  const Fits fits = fit_all(arm, episodes, fit_to);
  report.fitted_to = fitted_to_words(episodes, fit_to);
  measurement.add("static_linear", "line from commands", static_linear(arm, episodes, fits));
  measurement.add("linear_one_step", "linear step, run freely",
                  linear_one_step(arm, episodes, fits));
  measurement.add("simple_model", "fitted simple model", simple_model(fits));
  return report;
}

}  // namespace limber
