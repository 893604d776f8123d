#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/training/evaluation.hpp"

namespace limber {

/// One predictor beside the others.
struct PredictorErrors {
  std::string key;    ///< of JSON: "no_load", "network", "hold", "linear_one_step", …
  std::string label;  ///< "hold the pose"
  /// Of a yardstick, which costs nothing to build: what a network has to beat. None of the models,
  /// of which Evaluation has them, nor of measure_horizons.
  std::optional<RolloutErrors> errors;
  std::vector<double> tip_cm;      ///< one for each of YardstickReport::horizon_frames
  std::vector<double> episode_cm;  ///< open loop, mean tip error in each episode; NaN: none tracked
};

/// The yardsticks of one recording, docs/training.md.
struct YardstickReport {
  std::vector<PredictorErrors> predictors;
  std::string fitted_to;            ///< what those that are fitted were fitted to, in words
  std::vector<int> horizon_frames;  ///< 1, 2, 4, … and the longest episode: frames between restarts
  std::vector<std::string> episode_names;  ///< "episode 7", with the log that it came from
};

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

/// Holds the pose; holds the velocity; a linear model of one step, run freely; the fitted simple
/// model. The last two are fitted to `fit_to`, or, where that is empty, to the recording itself, a
/// fifth of it left out in turn: what predicts an episode has not been fitted to it.
/// @param network  may be null
/// @param note  told the share that is done; may be empty
/// @throws InputError as require_episodes_of, and where a prediction of the network is not finite.
YardstickReport measure_yardsticks(const ArmDescription& arm, const ForwardModel& no_load,
                                   const ForwardModel* network,
                                   const std::vector<Episode>& episodes,
                                   const std::vector<Episode>& fit_to, int jobs = 0,
                                   const std::function<void(double)>& note = {});

/// The curves alone of what nothing is fitted for, the models and holding the pose: for whoever
/// waits. Takes `note` and throws as above.
YardstickReport measure_horizons(const ForwardModel& no_load, const ForwardModel* network,
                                 const std::vector<Episode>& episodes, int jobs,
                                 const std::function<void(double)>& note);

/// Whether the record of the model's training names a file of this content.
bool learnt_from(const CompensationModel& model, const std::string& content_hash);

}  // namespace limber
