#include "limber/training/adaptation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <Eigen/Eigenvalues>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/physical_traits.hpp"
#include "limber/training/arm_fit.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "rollout.hpp"
#include "training_tables.hpp"

namespace limber {

namespace {

constexpr double kHeldBackShare = 0.2;
constexpr int kLeastFrames = 40;  // of all: less is no motion
constexpr int kMinHeldBackFrames = 40;
constexpr double kTooWrong = 1.5;  // times the error of the family's own arms: it is none of them
// Of the error of e alone: weights have to be better than that. The seconds held back chose their
// epoch, so that a little better on them may be worse elsewhere.
constexpr double kWorthIt = 0.9;
constexpr double kMovedM = 0.001;  // in a frame: less is a tracker's noise, or rest
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Of all episodes together, the end; nothing where what is left could not be fitted to.
struct Halves {
  std::vector<Episode> seen;
  std::vector<Episode> held_back;
};

Halves split(const std::vector<Episode>& episodes) {
  int left = int(std::lround(kHeldBackShare * double(frame_count(episodes))));
  Halves halves{episodes, {}};
  if (left < kMinHeldBackFrames) {
    return halves;
  }
  while (left > 0) {
    Episode& last = halves.seen.back();
    const int taken = std::min(left, last.frame_count());
    const int kept = last.frame_count() - taken;
    halves.held_back.insert(halves.held_back.begin(), slice(last, kept, taken));
    if (kept > 0) {
      last = slice(last, 0, kept);
    } else {
      halves.seen.pop_back();
    }
    left -= taken;
  }
  return can_be_fitted_to(halves.seen) ? halves : Halves{episodes, {}};
}

/// Whether weights find a window to learn from, in which the arm was tracked.
bool can_be_learnt_from(const std::vector<Episode>& episodes, const TrainingSettings& settings) {
  return std::ranges::any_of(episodes, [&](const Episode& episode) {
    const EpisodeRange whole{0, episode.frame_count()};
    const int frames = settings.stages.front().window_frames;
    return !window_starts(std::span(&whole, 1), episode.tracked, frames, 0).empty();
  });
}

/// Frames between tracked ones in which the arm moved: a tracker may be slower than the arm.
int moving_frames(const Episode& episode) {
  const auto place = [&](int t) { return places_at(episode.backbone, t, episode.dimension); };
  int count = 0;
  int before = -1;
  for (const int t : tracked_frames(episode)) {
    const int frames = t - before;
    if (before >= 0 && largest_place_distance_m(place(t), place(before)) > kMovedM * frames) {
      count += frames;
    }
    before = t;
  }
  return count;
}

class Adapter {
 public:
  Adapter(const ArmDescription& arm, const CompensationModel& family,
          const AdaptationSettings& settings)
      : arm_(arm), family_(family_of(family)), settings_(settings) {}

  Adaptation run(const std::vector<Episode>& episodes) {
    const Halves halves = settings_.measures_errors ? split(episodes) : Halves{episodes, {}};
    const ArmFit whole = fit_arm(arm_, family_, episodes, settings_.jobs);
    Adaptation result;
    result.model = whole.model;
    result.distance = whole.distance;
    result.expected_error_m = whole.expected_error_m;
    result.distance_to_nearest = whole.distance_to_nearest;
    note_uncertainty(result);
    result.traits = physical_traits(*result.model.family, *result.model.member_of_family);
    result.seconds = double(frame_count(episodes)) * arm_.frame_period_s();
    for (const Episode& episode : episodes) {
      result.moving_s += moving_frames(episode) * arm_.frame_period_s();
    }
    result.family_error_m = noted_error_m(family_, "validation_position_error_cm");
    result.middle_error_m = result.fitted_error_m = result.trained_error_m = kUnknown;
    const IdentifiedValves valves = identify_valves(episodes, arm_, "the recording");
    if (!halves.held_back.empty()) {
      judge(halves, episodes, valves, result);
    }
    if (!result.model.learnt_from_setpoints) {
      result.model.set_valves(valves);
    }
    note_shapes(arm_, result.model, episodes, settings_.jobs);
    if (const double usual_m = expected_error_of_tube_m(family_);
        family_.tube && usual_m > 0.0 && !result.has_trained_weights) {
      result.model.tube = scaled(*family_.tube, result.expected_error_m / usual_m);
    }
    return result;
  }

 private:
  double error_on(const CompensationModel& model, const std::vector<Episode>& episodes) const {
    return tip_error_m(ForwardModel(arm_, model), episodes, kValidationFrames, settings_.jobs);
  }

  static void note_uncertainty(Adaptation& result) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXf> axes(
        result.model.member_of_family->covariance);
    const Eigen::VectorXf deviation = axes.eigenvalues().cwiseMax(0.0F).cwiseSqrt();
    result.uncertainty = std::sqrt(deviation.squaredNorm() / float(deviation.size()));
    result.largest_uncertainty = deviation.maxCoeff();
  }

  /// What the seconds held back say, and the weights that they ask for.
  void judge(const Halves& halves, const std::vector<Episode>& episodes,
             const IdentifiedValves& valves, Adaptation& result) const {
    result.held_back_s = double(frame_count(halves.held_back)) * arm_.frame_period_s();
    CompensationModel before = fit_arm(arm_, family_, halves.seen, settings_.jobs).model;
    result.middle_error_m = error_on(family_, halves.held_back);
    result.fitted_error_m = error_on(before, halves.held_back);
    const bool is_too_wrong = result.fitted_error_m > kTooWrong * result.family_error_m;
    if (settings_.weights == AdaptWeights::automatic && !std::isnan(result.fitted_error_m) &&
        (is_too_wrong || result.distance > Adaptation::kFarFromFamily) &&
        can_be_learnt_from(halves.seen, settings_of_weights())) {
      TrainingResult trained = trained_on(before, halves.seen, halves.held_back);
      result.trained_error_m = error_on(trained.model, halves.held_back);
      if (result.trained_error_m < kWorthIt * result.fitted_error_m) {
        TrainingResult again = trained_on(result.model, episodes, {}, trained.best_epoch);
        if (again.best_epoch == trained.best_epoch) {  // else it is not what was judged
          result.has_trained_weights = true;
          result.model = std::move(again.model);
          before = std::move(trained.model);
        }
      }
    }
    if (!before.learnt_from_setpoints) {
      before.set_valves(valves);
    }
    result.model.prediction_error = measure_prediction_error(arm_, before, episodes, settings_.jobs,
                                                             int(frame_count(halves.seen)));
  }

  TrainingSettings settings_of_weights() const {
    TrainingSettings settings = fine_tuning_of(best_preset());
    settings.seed = settings_.seed;
    settings.jobs = settings_.jobs;
    settings.validation_interval = 5;
    return settings;
  }

  /// Weights trained further. What validates only says which epoch is the best.
  /// @param keep_epoch  without validation: the one that is kept
  TrainingResult trained_on(const CompensationModel& start, const std::vector<Episode>& training,
                            const std::vector<Episode>& validation, int keep_epoch = 0) const {
    const TrainingData data{training, validation};
    const TrainingHooks hooks{.should_stop = interrupt_requested};
    TrainingSettings settings = settings_of_weights();
    settings.keep_epoch = keep_epoch;
    TrainingResult result = fine_tune(arm_, data, settings, start, hooks);
    if (result.status == TrainingStatus::interrupted) {
      throw Interrupted("stopped while weights were trained");
    }
    if (result.best_epoch == 0) {
      result.model = start;
    }
    result.model.learnt = start.learnt;
    return result;
  }

  const ArmDescription& arm_;
  CompensationModel family_;
  const AdaptationSettings& settings_;
};

}  // namespace

Adaptation adapt(const ArmDescription& arm, const CompensationModel& family,
                 const std::vector<Episode>& episodes, const AdaptationSettings& settings) {
  const auto frames = frame_count(episodes);
  refuse_if(frames < kLeastFrames,
            "{} frames in {} episodes are too few to tell which arm it is; expected {} at least, "
            "better a minute of motions",
            frames, episodes.size(), kLeastFrames);
  return Adapter(arm, family, settings).run(episodes);
}

}  // namespace limber
