#include "limber/training/cross_validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data_survey.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/training/run_errors.hpp"
#include "limber/training/unseen_error.hpp"
#include "other_seeds.hpp"
#include "rollout.hpp"
#include "shuffle.hpp"

namespace limber {

namespace {

constexpr double kMaxHours = 1.0;  // with more, a tenth held back costs less than it tells
constexpr int kLittleWindowFrames = 32;
constexpr double kFirstFramesPower = 1.5;
constexpr int kRunEpochs = 300;    // 100 were never better; 600 no better
constexpr double kSoapRate = 2.0;  // over Adam's, on stand-ins (docs/log/2026-11-27-training.md)
// A way whose first network is worse than the best's by more is not tried any further: two seeds of
// one way differ by 3 to 10 %.
constexpr double kWorthTrying = 1.05;
constexpr std::uint64_t kFoldStream = 0x666f6c6473;
constexpr double kNever = std::numeric_limits<double>::infinity();  // an error
constexpr int kMinPartFrames = 100;  // a rollout over less says little

/// What is tried: the preset's wide layer, which learns little of the noise, and three of 100,
/// better where recordings are clean; or the user's layers.
std::vector<WayTried> ways_to_try(const std::vector<int>& hidden_units) {
  const std::vector<int> one = hidden_units.empty() ? best_preset().hidden_units : hidden_units;
  std::vector<WayTried> ways{{kRunEpochs, one, Optimiser::soap},
                             {kRunEpochs, one, Optimiser::adam}};
  if (hidden_units.empty()) {
    ways.push_back({kRunEpochs, TrainingSettings().hidden_units, Optimiser::adam});
  }
  return ways;
}

/// `settings` for a run of that way.
TrainingSettings settings_of(const WayTried& way, TrainingSettings settings) {
  set_epoch_count(settings, way.epochs);
  settings.keep_epoch = way.epochs;
  settings.hidden_units = way.hidden_units;
  settings.optimiser = way.optimiser;
  settings.learning_rate *= way.optimiser == Optimiser::soap ? kSoapRate : 1.0;
  return settings;
}

/// The parts that folds are made of, and what is learnt from in all of them.
struct Parts {
  std::vector<Episode> moving;
  std::vector<Episode> resting;
};

/// Whether a rollout over it says anything: it moves, was seen, and is longer than a window.
bool can_judge(const ArmDescription& arm, const Episode& episode) {
  return episode.frame_count() > kLittleWindowFrames + 1 &&
         episode.frame_count() - episode.untracked_count() >= 2 && moves(arm, episode);
}

Parts parts_of(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  Parts parts;
  for (const Episode& episode : episodes) {
    (can_judge(arm, episode) ? parts.moving : parts.resting).push_back(episode);
  }
  while (!parts.moving.empty() && parts.moving.size() < 2 * kFolds) {
    Episode& longest = *std::ranges::max_element(parts.moving, {}, &Episode::frame_count);
    const int frames = longest.frame_count();
    if (frames < 2 * kMinPartFrames) {
      break;
    }
    Episode rest = slice(longest, frames / 2, frames - frames / 2);
    longest = slice(longest, 0, frames / 2);
    parts.moving.push_back(std::move(rest));
  }
  const auto judging = std::stable_partition(
      parts.moving.begin(), parts.moving.end(),
      [&](const Episode& part) { return can_judge(arm, part); });  // a half may rest
  std::move(judging, parts.moving.end(), std::back_inserter(parts.resting));
  parts.moving.erase(judging, parts.moving.end());
  return parts;
}

/// The fold of each part: the longest ones first, each to the fold that has least.
std::vector<int> deal(const std::vector<Episode>& parts, std::uint64_t seed) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random(seed, kFoldStream);
  shuffle(random, order);
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t i) { return parts[i].frame_count(); });
  std::array<int, kFolds> frames{};
  std::vector<int> folds(parts.size());
  for (const std::size_t i : order) {
    const auto least = std::ranges::min_element(frames);
    folds[i] = int(least - frames.begin());
    *least += parts[i].frame_count();
  }
  return folds;
}

class CrossValidator {
 public:
  CrossValidator(const ArmDescription& arm, const std::vector<Episode>& episodes,
                 const TrainingSettings& settings, const IdentifiedValves& valves,
                 const TrainingHooks& hooks)
      : arm_(arm),
        identity_(folds_identity(arm, episodes, settings)),
        parts_(parts_of(arm, episodes)),
        fold_(deal(parts_.moving, settings.seed)),
        settings_(settings),
        valves_(valves),
        hooks_(hooks) {
    refuse_if(
        parts_.moving.size() < kFolds,
        "{} parts of more than {} frames in which the arm moves; {} folds need one each. Give "
        "more of its motion, or a recording of its own that validates",
        parts_.moving.size(), kLittleWindowFrames + 1, kFolds);
    settings_.checkpoint.clear();
    settings_.resume = false;
    settings_.ensemble = 1;
  }

  CrossValidation run() {
    for (const WayTried& way : ways_to_try(settings_.hidden_units)) {
      attempts_.emplace_back().way = way;
      add_fold(attempts_.back());
    }
    std::vector<std::pair<double, Attempt*>> order;
    for (Attempt& attempt : attempts_) {
      const double first_cm = attempt.way.score_cm();
      order.emplace_back(std::isfinite(first_cm) ? first_cm : kNever, &attempt);
    }
    std::ranges::stable_sort(order, {}, [](const auto& of_first) { return of_first.first; });
    double best_cm = kNever;
    for (const auto& [first_cm, attempt] : order) {
      if (first_cm < kWorthTrying * best_cm && add_folds(*attempt)) {
        best_cm = std::min(best_cm, first_cm);
      }
    }
    return verdict();
  }

 private:
  struct Attempt {
    WayTried way;  ///< errors are means over the folds so far
    RunErrors errors;
    std::array<double, 3> shares{};  ///< of all frames that judge, in each of its errors
  };

  /// A network for each fold that is left, as long as none diverges. @returns whether none did
  bool add_folds(Attempt& attempt) {
    while (attempt.way.folds < kFolds && std::isfinite(attempt.way.score_cm())) {
      add_fold(attempt);
    }
    return std::isfinite(attempt.way.score_cm());
  }

  /// Another network of that way, and what all of them are worth together.
  void add_fold(Attempt& attempt) {
    WayTried& way = attempt.way;
    TrainingData data;
    data.training = parts_.resting;
    std::vector<Episode> unseen;
    for (std::size_t i = 0; i < parts_.moving.size(); ++i) {
      (fold_[i] == way.folds ? unseen : data.training).push_back(parts_.moving[i]);
    }
    ++way.folds;
    TrainingResult trained = train(arm_, data, settings_of(way, settings_), hooks_);
    if (trained.status == TrainingStatus::interrupted) {
      throw Interrupted("stopped while cross-validation looked for the way to learn");
    }
    trained.model.set_valves(valves_);
    if (trained.status != TrainingStatus::finished ||
        !attempt.errors.add(arm_, trained.model, unseen, settings_.jobs)) {
      message_ = trained.message;
      way.one_step_cm = way.window_32_cm = way.window_600_cm = kNever;
      return;
    }
    const ForwardModel model(arm_, std::move(trained.model));
    const double share = double(frame_count(unseen)) / double(frame_count(parts_.moving));
    const auto add = [&](double& mean_cm, double& shares, int frames) {
      if (measured_frames(unseen, pieces_of_length(unseen, frames)) == 0) {
        return;  // a tracker slower than the arm sees no frame right behind another
      }
      shares += share;
      const double error_cm = kCmPerM * tip_error_m(model, unseen, frames, settings_.jobs);
      mean_cm += share / shares * ((std::isfinite(error_cm) ? error_cm : kNever) - mean_cm);
    };
    add(way.one_step_cm, attempt.shares[0], 1);
    add(way.window_32_cm, attempt.shares[1], 32);
    add(way.window_600_cm, attempt.shares[2], 600);
    throw_if_interrupted();
  }

  CrossValidation verdict() {
    CrossValidation found;
    found.identity = identity_;
    found.folds = kFolds;
    const Attempt* best = nullptr;
    for (const Attempt& attempt : attempts_) {
      if (attempt.way.folds == kFolds && std::isfinite(attempt.way.score_cm()) &&
          (best == nullptr || attempt.way.score_cm() < best->way.score_cm())) {
        best = &attempt;
        found.chosen = int(found.tried.size());
      }
      found.tried.push_back(attempt.way);
    }
    if (best == nullptr) {
      throw InputError(
          fmt::format("no network of cross-validation predicts finite shapes: {}",
                      message_.empty() ? "look at the data with limber inspect" : message_));
    }
    found.prediction_error = best->errors.result(arm_.frame_period_s());
    if (!arm_.is_spatial()) {  // which can't be planned for yet
      found.tube = best->errors.tube(arm_.length_m());
      found.widest_where = best->errors.widest_where(arm_.command.unit);
    }
    return found;
  }

  const ArmDescription& arm_;
  std::string identity_;
  Parts parts_;
  std::vector<int> fold_;  // of each moving part
  TrainingSettings settings_;
  const IdentifiedValves& valves_;
  const TrainingHooks& hooks_;
  std::vector<Attempt> attempts_;
  std::string message_;  // of a run that diverged
};

}  // namespace

bool is_little(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  constexpr double kSecondsPerHour = 3600.0;
  return double(frame_count(episodes)) * arm.frame_period_s() <= kMaxHours * kSecondsPerHour &&
         parts_of(arm, episodes).moving.size() >= kFolds;
}

TrainingSettings preset_for_little() {
  TrainingSettings settings = best_preset();
  settings.first_frames_power = kFirstFramesPower;
  settings.hidden_units.clear();
  return settings;
}

std::string folds_identity(const ArmDescription& arm, const std::vector<Episode>& episodes,
                           const TrainingSettings& settings) {
  return content_hash(fmt::format("{} {} {} {} {} {}", arm.hash(),
                                  fmt::join(settings.hidden_units, "-"), settings.reads_velocity,
                                  settings.learning_rate, settings.seed, hash_of(episodes)));
}

CrossValidation cross_validate(const ArmDescription& arm, const std::vector<Episode>& episodes,
                               const TrainingSettings& settings, const IdentifiedValves& valves,
                               const TrainingHooks& hooks) {
  return CrossValidator(arm, episodes, settings, valves, hooks).run();
}

bool take_another_way(CrossValidation& found) {
  WayTried& diverged = found.tried[found.chosen];
  diverged.one_step_cm = diverged.window_32_cm = diverged.window_600_cm = kNever;
  found.prediction_error.reset();  // of the other's networks, as the tube
  found.tube.reset();
  found.widest_where.clear();
  // Means over fewer folds are of other episodes: they say less, and may look better.
  const auto rank = [&](const WayTried& way) {
    return std::tuple(!std::isfinite(way.score_cm()), way.folds < found.folds, way.score_cm());
  };
  const auto next = std::ranges::min_element(found.tried, {}, rank);
  found.chosen = int(next - found.tried.begin());
  return std::isfinite(next->score_cm());
}

TrainingResult train_on_everything(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                   const TrainingSettings& settings, const IdentifiedValves& valves,
                                   const CrossValidation& found, const TrainingHooks& hooks) {
  const TrainingData data{episodes, {}};
  TrainingResult result = train_until_bounded(
      [&](const TrainingSettings& with) { return train(arm, data, with, hooks); },
      settings_of(found.best(), settings));
  if (result.best_epoch > 0) {
    result.model.set_valves(valves);
    if (!arm.is_spatial()) {
      result.model.learnt = learnt_region_of(data);
    }
    if (result.status == TrainingStatus::finished && result.best_epoch == found.epochs()) {
      result.model.prediction_error = found.prediction_error;
      result.model.tube = found.tube;
    }
    note_shapes(arm, result.model, episodes, settings.jobs);
  }
  return result;
}

}  // namespace limber
