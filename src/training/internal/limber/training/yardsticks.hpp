#pragma once

#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/training/tip_errors.hpp"

namespace limber {

/// Errors of one predictor at every horizon that networks have.
struct HorizonErrors {
  TipErrors one_step;
  TipErrors one_step_moving;
  TipErrors window_32;
  TipErrors per_motion;
  TipErrors open_loop;
};

/// A predictor that costs nothing to build: what a network has to beat.
struct Yardstick {
  std::string key;    ///< of JSON: "hold", "static_linear", …
  std::string label;  ///< "hold the pose"
  HorizonErrors errors;
};

/// One predictor beside the others: over horizons, and over episodes.
struct PredictorCurve {
  std::string key;  ///< "no_load", "network", or a yardstick's
  std::string label;
  std::vector<double> tip_cm;      ///< one for each of YardstickReport::horizon_frames
  std::vector<double> episode_cm;  ///< open loop, mean tip error in each episode; NaN: none tracked
};

/// The yardsticks of one recording, docs/training.md.
struct YardstickReport {
  std::vector<Yardstick> yardsticks;
  std::string fitted_to;            ///< what those that are fitted were fitted to, in words
  std::vector<int> horizon_frames;  ///< 1, 2, 4, … and the longest episode: frames between restarts
  std::vector<PredictorCurve> curves;
  std::vector<std::string> episode_names;  ///< "episode 7", with the log that it came from
};

/// Holds the pose; holds the velocity; a line from commands to poses; a linear model of one step,
/// run freely; the fitted simple model. The last three are fitted to `fit_to`, or, where that is
/// empty, to the recording itself, a fifth of it left out in turn: what predicts an episode has not
/// been fitted to it.
/// @param network  may be null
/// @throws InputError as require_episodes_of, and where a prediction of the network is not finite.
YardstickReport measure_yardsticks(const ArmDescription& arm, const ForwardModel& no_load,
                                   const ForwardModel* network,
                                   const std::vector<Episode>& episodes,
                                   const std::vector<Episode>& fit_to, int jobs = 0);

}  // namespace limber
