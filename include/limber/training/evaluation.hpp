#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"

namespace limber {

/// Over frames: mean, standard deviation (of the population) and 95th percentile.
struct ErrorStatistics {
  double mean = 0.0;
  double std = 0.0;
  double p95 = 0.0;
};

/// Errors of the end effector.
struct TipErrors {
  ErrorStatistics position_cm;
  ErrorStatistics orientation_rad;
};

/// How often a prediction is corrected from the recording. One step alone says little: holding the
/// previous pose is already good at it (docs/training.md).
enum class Restart {
  every_frame,       ///< one_step
  every_32_frames,   ///< window_32
  every_motion,      ///< per_motion
  at_the_start_only  ///< open_loop
};

struct RolloutErrors {
  TipErrors one_step;
  TipErrors window_32;
  TipErrors per_motion;
  TipErrors open_loop;
};

/// Errors of the models and of two trivial predictors on one recording (INTERFACE: evaluate
/// --json).
struct Evaluation {
  std::int64_t frames = 0;
  TipErrors no_load_open_loop;
  std::optional<RolloutErrors> network;
  TipErrors hold_one_step;                  ///< B_t = B_{t−1}
  TipErrors constant_velocity_one_step;     ///< B_t = 2 B_{t−1} − B_{t−2}
  double position_reduction_percent = 0.0;  ///< open loop, network against no load
  double orientation_reduction_percent = 0.0;
};

/// Predicted backbones of an episode (T×3m), fed with its measured pressures: row 0 is the recorded
/// first backbone, and so is the state before every restart. A restart waits for the next frame in
/// which the arm was seen; frames that are not predicted are NaN. Batched over restarts, and over
/// `jobs` threads; the result does not depend on their number.
FrameMatrix predict(const ForwardModel& model, const Episode& episode, Restart restart,
                    int jobs = 0);

/// Errors of predicted tips, one a frame.
struct TipErrorSeries {
  std::vector<double> position_cm;
  std::vector<double> orientation_rad;
};
/// Frames `first` and later of `predicted` (T×3m) against those recorded; NaN where the arm was not
/// seen or nothing was predicted.
TipErrorSeries tip_errors(const FrameMatrix& predicted, const Episode& episode, int first);
/// Statistics over the frames that are not NaN.
TipErrors summarise(const TipErrorSeries& series);

/// @param network  null: no-load model only.
/// @throws InputError where the recording has no episode of at least three frames.
Evaluation evaluate(const ForwardModel& no_load, const ForwardModel* network,
                    const std::vector<Episode>& episodes, int jobs = 0);

/// The object of `evaluate --json`.
nlohmann::ordered_json evaluation_to_json(const Evaluation& evaluation);
/// The same as a table for people.
std::string evaluation_to_text(const Evaluation& evaluation);

}  // namespace limber
