#pragma once
// For those who train and evaluate models.

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/long_rollout.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

inline constexpr int kSliceFrames = 400'000;  // 1.2 GB: one is learnt from, the next one read

/// Episodes that do not fit in memory: a slice of them is there at a time, and the next one.
struct SlicedEpisodes {
  std::vector<int> frame_counts = {};  ///< of each; empty: there are none
  /// Those that have these numbers, which rise.
  std::function<std::vector<Episode>(std::span<const int>)> read = {};
  int slice_frames = kSliceFrames;  ///< about as many; an episode is never cut
};

/// The data for training, and those for choosing the best epoch; never the test data.
struct TrainingData {
  std::vector<Episode> training;
  std::vector<Episode> validation;
  /// What a model to be fine-tuned was trained on before. A share of every epoch's windows
  /// (TrainingSettings::replay_share) comes from here, so that the model does not forget it.
  std::vector<Episode> replay = {};
  /// The finished model's error is measured on these data; `train` never uses them.
  std::vector<Episode> unseen = {};
  /// For a family: which arm each training episode was recorded on, from 0. Empty: every one on an
  /// arm of its own.
  std::vector<int> arms = {};
  /// … and what is known of each of those arms (Episode::physics); fewer than there are, or empty
  /// ones: nothing of the others.
  std::vector<std::string> physics = {};
  /// Which of the episodes given to `hold_back_validation` validate, rising; empty where none were
  /// held back.
  std::vector<int> held_back = {};
  /// In place of `training`: every epoch learns from one slice after the other, each a random share
  /// of the episodes. Inputs are scaled by what the first slice spans. Each episode is read twice,
  /// and lies on disk meanwhile, beside the checkpoint.
  SlicedEpisodes slices = {};
};

/// Holds back whole episodes for validation, chosen by `seed`: about `fraction` of the frames, at
/// least one episode. Where the longest has over 40 % of all frames, and twice what is wanted, its
/// end alone is held back, up to the last tracked frame. Episodes in which no tracked frame is
/// behind another measure no error: they stay, and do not count.
/// @throws InputError if nothing would be left to learn from, or measures an error.
TrainingData hold_back_validation(std::vector<Episode> episodes, double fraction,
                                  std::uint64_t seed);

/// Then holds back for `data.unseen` about `fraction` of the frames of training and validation:
/// whole training episodes, chosen by `seed`, of which one stays; or the end of the longest one,
/// if that is more than twice as long; of those that measure an error. Nothing if that is too
/// short. Validation episodes stay as they are. Call it after `hold_back_validation`, or before
/// validation episodes come from elsewhere.
void hold_back_unseen(TrainingData& data, double fraction, std::uint64_t seed);

/// For a family: holds back whole arms, with all of their episodes, for validation: about
/// `fraction` of the arms, chosen by `seed`; none of fewer than kMinArmsToHoldBack.
/// @param arms  the arm of each episode, any numbers
TrainingData hold_back_arms(std::vector<Episode> episodes, const std::vector<int>& arms,
                            double fraction, std::uint64_t seed);

inline constexpr int kMinArmsToHoldBack = 10;

/// Adds the arm of each of a recording's episodes to `arms`, in numbers that none of these has: all
/// are of one, but virtual arms that vary from episode to episode (Episode::physics).
void add_arms_of(const Recording& recording, std::vector<int>& arms);

/// For a family: the mirror image of every training arm, left for right, is an arm of the family
/// too, and costs no motion. Adds none where an arm's pressure limits differ from side to side: the
/// image would go beyond them.
void add_mirrored_arms(const ArmDescription& arm, TrainingData& data);

/// One row of the learning curve.
struct LearningCurvePoint {
  int epoch = 0;  ///< from 1
  int window_frames = 0;
  double learning_rate = 0.0;
  double loss = 0.0;                        ///< mean frame error, normalised units
  double validation_position_error_cm = 0;  ///< of the tip, see `train`; NaN if not measured
  double elapsed_s = 0.0;
};

/// What a caller is told of a run, and asked. Both are called on the thread that trains.
struct TrainingHooks {
  /// After every epoch.
  std::function<void(const LearningCurvePoint&)> on_epoch = {};
  /// Before every batch; true stops the run as Ctrl-C does. An epoch that was begun is dropped, so
  /// that a checkpoint goes on from the last one stored. Empty: never.
  std::function<bool()> should_stop = {};
};

enum class TrainingStatus { finished, interrupted, diverged };

struct TrainingResult {
  TrainingStatus status = TrainingStatus::finished;
  std::string message;  ///< why it diverged, and what to try
  /// Best by validation so far; an ensemble's members are in the order of their validation errors.
  /// Has no layers if no epoch was validated.
  CompensationModel model;
  std::vector<LearningCurvePoint> curve;
  int best_epoch = 0;
  /// Epochs with smaller validation errors that were passed over, because a long rollout of their
  /// networks ran away (LongRollout::bounded); of a finished run.
  std::vector<int> passed_over_epochs;
  LongRollout long_rollout;  ///< of the epoch chosen, its worst network; of a finished run
  double best_validation_position_error_cm = 0.0;           ///< NaN without validation data
  std::vector<double> member_validation_position_error_cm;  ///< in the model's order
  double wall_time_s = 0.0;
};

/// Trains the network Φ of (5) by back-propagation through windows (docs/training.md).
///
/// Validation error: mean distance of the tip over open-loop rollouts of up to 600 frames that
/// cover the validation episodes. For an ensemble it is that of the mean of its members'
/// predictions, each member rolled out by itself; of a family, after each held-back arm was fitted.
/// Untracked frames don't count. Without validation data the loss decides.
///
/// The networks' predictions stay within bounds (20), recorded ranges and a margin. The best epochs
/// of each tenth of the run are kept; the one with the smallest validation error is chosen whose
/// networks do not run away in a rollout of kLongRolloutFrames, the best one if all do.
/// @throws InputError if the data don't fit the arm, are too short for one window, or hold set
/// points alone in some episodes and measured pressures in others: a model learns from one kind,
/// and says from which (CompensationModel::learnt_from_setpoints).
[[nodiscard]] TrainingResult train(const ArmDescription& arm, const TrainingData& data,
                                   const TrainingSettings& settings,
                                   const TrainingHooks& hooks = {});

/// The same, from the weights of `start` (fine-tuning): its layout, hidden units, members and
/// normalisation are kept. @throws InputError if it is another arm's, or learnt
/// from the other kind.
[[nodiscard]] TrainingResult fine_tune(const ArmDescription& arm, const TrainingData& data,
                                       const TrainingSettings& settings,
                                       const CompensationModel& start,
                                       const TrainingHooks& hooks = {});

/// Columns epoch, window_frames, learning_rate, loss, validation_position_error_cm, elapsed_s.
void write_learning_curve_csv(const std::filesystem::path& path,
                              const std::vector<LearningCurvePoint>& curve);

}  // namespace limber
