#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "epoch_trainer.hpp"

namespace limber {

/// One training run: the loop over stages and epochs, validation, checkpoints and the time limit.
class TrainingRun {
 public:
  /// @param start  networks to begin with; null: sampled from the seed.
  TrainingRun(const ArmDescription& arm, const TrainingData& data, TrainingSettings settings,
              const CompensationModel* start, const TrainingHooks& hooks);

  TrainingResult run();

 private:
  void fit_epochs_to_time_limit();
  double seconds_per_epoch(const TrainingStage& stage);
  void resume();
  void store(bool now);
  /// The last epoch of the run.
  int end() const;
  /// All epochs that are left, and the choice among them.
  /// @throws Interrupted between two epochs, or while the last one is validated.
  TrainingResult run_stages();
  /// Trains epochs of one stage up to its last or the run's, from where the state is. Empty if it
  /// finished.
  std::optional<TrainingResult> run_stage(const TrainingStage& stage, int stage_end,
                                          Progress& progress);
  /// Validates the last epoch where it is to be, and tells of it.
  void finish_epoch(Progress& progress);
  bool is_validated(int epoch) const;
  void validate(LearningCurvePoint& point);
  double elapsed_s() const;
  std::string progress_note(const LearningCurvePoint& point) const;
  /// The worst of the networks with these weights.
  LongRollout roll_out_long_each(const Eigen::VectorXf& weights) const;
  /// Of a finished run: the best epoch whose networks do not run away.
  TrainingResult chosen_result() const;
  TrainingResult result(TrainingStatus status, std::string message) const;
  /// @param choice  the epoch whose networks are the model; null: there is none
  TrainingResult result(TrainingStatus status, std::string message,
                        const ValidatedEpoch* choice) const;
  std::string divergence_message(int epoch, const EpochLoss& loss) const;

  const ArmDescription& arm_;
  const TrainingData& data_;
  TrainingSettings settings_;
  const TrainingHooks& hooks_;
  EpochTrainer trainer_;
  std::string identity_;  ///< of the checkpoint, where one is asked for
  std::chrono::steady_clock::time_point begin_;
  double elapsed_before_s_ = 0.0;  ///< in the run that this one resumes
  double stored_s_ = 0.0;          ///< when the last checkpoint was written
};

}  // namespace limber
