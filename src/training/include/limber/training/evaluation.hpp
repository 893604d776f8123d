#pragma once
// For those who train and evaluate models.

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/training/long_rollout.hpp"
#include "limber/training/tip_errors.hpp"

namespace limber {

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
  TipErrors one_step_moving;  ///< of the frames in which the arm moved: most of the others are easy
  TipErrors window_32;
  TipErrors per_motion;
  TipErrors open_loop;
  /// Open loop too, with the pressures that the model's valves make of the recording's set points:
  /// this is how good a plan's prediction is. None if the model has no valves, or the recording no
  /// set points of its own.
  std::optional<TipErrors> open_loop_from_setpoints;
};

/// Tracked frames of a recording, and how many of them lie beyond what a model learnt from
/// (LearntRegion, docs/training.md), apart for pressures within its recorded ranges and beyond.
struct NovelFrames {
  struct Count {
    std::int64_t frames = 0;
    std::int64_t novel = 0;
  };
  Count pressures_within;
  Count pressures_beyond;
};
NovelFrames find_novel_frames(const LearntRegion& learnt, const std::vector<Episode>& episodes);

/// Errors of the models and of two trivial predictors on one recording (INTERFACE: evaluate
/// --json).
struct Evaluation {
  Command command;          ///< what drives the arm, for those who show this
  std::int64_t frames = 0;  ///< tracked ones after the first of each episode: those that count
  TipErrors no_load_open_loop;
  std::optional<RolloutErrors> network;
  double noise_multiplied = 0.0;     ///< of the network, if there is one
  LongRollout long_rollout;          ///< of the network, if there is one
  std::optional<NovelFrames> novel;  ///< to the network, where it knows what it learnt from
  TipErrors hold_one_step;           ///< B_t = B_{t−1}
  TipErrors hold_one_step_moving;
  TipErrors constant_velocity_one_step;  ///< B_t = 2 B_{t−1} − B_{t−2}
  TipErrors constant_velocity_one_step_moving;
  double position_reduction_percent = 0.0;  ///< open loop, network against no load
  double orientation_reduction_percent = 0.0;
};

/// Predicted backbones of an episode (T×3m) from its measured pressures. The state before the
/// first prediction and before every restart is the recorded one; a restart waits for the next
/// tracked frame. The no-load model needs no start. Frames that are not predicted are NaN: the
/// first, and those that are only a start. Batched over restarts, and over `jobs` threads; the
/// result does not depend on their number.
FrameMatrix predict(const ForwardModel& model, const Episode& episode, Restart restart,
                    int jobs = 0);

/// The same for several episodes, side by side.
/// @throws InputError as require_episodes_of, if a prediction is not finite, or if the network
/// learnt from set points and
/// the episodes hold what was measured, or the other way round (with_setpoints_only).
std::vector<FrameMatrix> predict(const ForwardModel& model, const std::vector<Episode>& episodes,
                                 Restart restart, int jobs = 0);

/// How many times as large the noise of a tracker comes out of the network after one step, at the
/// tip, as standard deviations: of a held pose 1, at constant velocity 2.2. 0 if no frame is known.
double noise_multiplied(const ForwardModel& network, const std::vector<Episode>& episodes,
                        int jobs = 0);

/// @param network  null: no-load model only.
/// @throws InputError if the recording has no episode of at least three frames, if `no_load` has a
/// network or `network` none, and as require_episodes_of.
Evaluation evaluate(const ForwardModel& no_load, const ForwardModel* network,
                    const std::vector<Episode>& episodes, int jobs = 0);

}  // namespace limber
