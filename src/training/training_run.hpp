#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "limber/training/batch_gradient.hpp"
#include "limber/training/optimiser.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/training_tables.hpp"

namespace limber {

/// Everything that changes while a network is trained: stored between epochs, it continues a run
/// bit for bit, for all chance is drawn from streams numbered by epoch.
struct TrainingState {
  int epochs_done = 0;
  Eigen::VectorXf parameters;
  Eigen::VectorXf average;  ///< moving average of the parameters; empty where it is off
  OptimiserState optimiser;
  Eigen::VectorXf best;  ///< parameters with the least validation error so far
  double best_error_m = 0.0;
  int best_epoch = 0;             ///< 0: none yet
  double stage_first_loss = 0.0;  ///< of the first batch of the stage that runs; 0: not begun
  std::vector<LearningCurvePoint> curve;
};

/// One training run: tables, state and the loop over stages, epochs and batches.
class TrainingRun {
 public:
  /// @param start  weights to begin with; null: drawn from the seed.
  TrainingRun(const ArmDescription& arm, const TrainingData& data, TrainingSettings settings,
              const CompensationModel* start);

  TrainingResult run();

 private:
  struct EpochLoss {
    double mean = 0.0;
    bool diverged = false;
  };

  void fit_epochs_to_time_limit();
  std::string identity() const;
  void resume();
  void store(bool now);
  /// Trains epochs of one stage up to its last, from where the state is. Empty where it finished.
  std::optional<TrainingResult> run_stage(const TrainingStage& stage, int last_epoch,
                                          Progress& progress);
  double seconds_per_epoch(const TrainingStage& stage);
  EpochLoss train_epoch(const TrainingStage& stage, BatchGradient& gradient);
  std::vector<int> shuffled_starts(const TrainingStage& stage) const;
  double learning_rate(double epochs) const;
  void step(double loss_scale, double rate);
  void validate(LearningCurvePoint& point);
  CompensationModel model_of(const Eigen::VectorXf& parameters) const;
  double elapsed_s() const;
  TrainingResult result(TrainingStatus status, std::string message) const;
  std::string divergence_message(int epoch, double loss) const;

  const ArmDescription& arm_;
  const TrainingData& data_;
  TrainingSettings settings_;
  TrainingTables tables_;
  ParameterLayout layout_;
  TrainingState state_;
  Eigen::VectorXf gradient_;
  std::string identity_;  ///< of the checkpoint, where one is asked for
  std::chrono::steady_clock::time_point begin_;
  double elapsed_before_s_ = 0.0;  ///< in the run that this one resumes
  double stored_s_ = 0.0;          ///< when the last checkpoint was written
};

}  // namespace limber
