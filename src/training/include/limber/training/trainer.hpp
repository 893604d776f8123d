#pragma once
// For those who train and evaluate models.

#include <filesystem>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// What is learnt from, and what the choice of the best epoch is made on; never the test data.
struct TrainingData {
  std::vector<Episode> training;
  std::vector<Episode> validation;
  /// What a model to be fine-tuned was trained on before: a share of every epoch's windows
  /// (TrainingSettings::replay_share) comes from here, so that it is not forgotten.
  std::vector<Episode> replay = {};
  /// What the finished model's error is measured on: `train` never looks at it.
  std::vector<Episode> unseen = {};
  /// Which of the episodes given to `hold_back_validation` validate, rising; empty where none were
  /// held back.
  std::vector<int> held_back = {};
};

/// Holds back whole episodes for validation, chosen by `seed`: about `fraction` of the frames, at
/// least one episode. Of a single episode the last `fraction` is held back.
/// @throws InputError where nothing would be left to learn from.
TrainingData hold_back_validation(std::vector<Episode> episodes, double fraction,
                                  std::uint64_t seed);

/// Takes broken episodes (EpisodeErrors::outliers) out of `data.validation`, so that none of them
/// chooses the epoch; where all are broken, none. @param broken  one for each of them
void leave_out_broken(TrainingData& data, const std::vector<bool>& broken);

/// Then holds back for `data.unseen` about `fraction` of the frames of training and validation:
/// whole training episodes, chosen by `seed`, of which one stays; or the end of the longest one,
/// where that is more than twice as long. Nothing where that is too short. What validates stays as
/// it is. To be called after `hold_back_validation`, or before validation episodes come from
/// elsewhere.
void hold_back_unseen(TrainingData& data, double fraction, std::uint64_t seed);

/// One row of the learning curve.
struct LearningCurvePoint {
  int epoch = 0;  ///< from 1
  int window_frames = 0;
  double learning_rate = 0.0;
  double loss = 0.0;                        ///< mean frame error, normalised units
  double validation_position_error_cm = 0;  ///< of the tip, see `train`; NaN where not measured
  double elapsed_s = 0.0;
};

enum class TrainingStatus { finished, interrupted, diverged };

struct TrainingResult {
  TrainingStatus status = TrainingStatus::finished;
  std::string message;  ///< why it diverged, and what to try
  /// Best by validation so far; an ensemble's members lie in the order of their validation errors.
  /// No layers where no epoch was validated.
  CompensationModel model;
  std::vector<LearningCurvePoint> curve;
  int best_epoch = 0;
  double best_validation_position_error_cm = 0.0;           ///< NaN without validation data
  std::vector<double> member_validation_position_error_cm;  ///< in the model's order
  double wall_time_s = 0.0;
};

/// Trains the network Φ of (5) by back-propagation through windows (docs/training.md).
///
/// Validation error: mean distance of the tip over open-loop rollouts of up to 600 frames that
/// cover the validation episodes; of an ensemble, of the mean of its members' predictions, each
/// member rolled out by itself. Frames in which the arm was not tracked don't count.
/// @throws InputError where the data don't fit the arm, or are too short for one window.
[[nodiscard]] TrainingResult train(const ArmDescription& arm, const TrainingData& data,
                                   const TrainingSettings& settings);

/// The same, from the weights of `start` (fine-tuning): its layout, hidden units, members and
/// normalisation are kept. @throws InputError where it is another arm's.
[[nodiscard]] TrainingResult fine_tune(const ArmDescription& arm, const TrainingData& data,
                                       const TrainingSettings& settings,
                                       const CompensationModel& start);

/// Columns epoch, window_frames, learning_rate, loss, validation_position_error_cm, elapsed_s.
void write_learning_curve_csv(const std::filesystem::path& path,
                              const std::vector<LearningCurvePoint>& curve);

}  // namespace limber
