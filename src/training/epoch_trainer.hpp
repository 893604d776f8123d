#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch_gradient.hpp"
#include "data_survey.hpp"
#include "limber/training/trainer.hpp"
#include "optimiser.hpp"
#include "spilled_tables.hpp"
#include "training_tables.hpp"

namespace limber {

/// An epoch's networks, kept in case that better ones turn out to run away.
struct ValidatedEpoch {
  int epoch = 0;
  double error_m = 0.0;           ///< of the mean of the networks' predictions
  std::vector<double> members_m;  ///< of each network
  Eigen::VectorXf weights;        ///< N·P
};

/// Of (16)'s gates, before training: they start at 1.1 %.
inline constexpr double kFirstGateBias = -4.5;

/// Everything that changes while networks are trained. Stored between epochs, it continues a run
/// bit for bit, because all random numbers come from streams numbered by epoch. P parameters per
/// network, N networks; the vectors hold one network after the other.
struct TrainingState {
  int epochs_done = 0;
  Eigen::VectorXf parameters;  ///< N·P
  OptimiserState optimiser;
  std::vector<ValidatedEpoch> rivals;    ///< the best epoch of each tenth of the run, rising
  std::vector<double> stage_first_loss;  ///< N, of the first batch of the stage; empty: not begun
  std::vector<LearningCurvePoint> curve;

  /// The first of the smallest error so far; null: none yet.
  const ValidatedEpoch* best() const;
};

/// Result of one epoch.
struct EpochLoss {
  double mean = 0.0;  ///< over windows and networks
  int diverged = -1;  ///< a network that diverged; −1: none
  double diverged_loss = 0.0;
  bool stopped = false;  ///< in the middle: the state is that of no epoch
};

/// Trains N networks of one shape together, batch by batch: each batch is gathered once.
class EpochTrainer {
 public:
  /// @param start  networks to begin with, as many as it has members; null: sampled from the seed.
  /// Keeps references to `settings`.
  EpochTrainer(const ArmDescription& arm, const TrainingData& data,
               const TrainingSettings& settings, const CompensationModel* start);

  int member_count() const { return members_; }
  const TrainingTables& tables() const { return tables_; }
  const DataSurvey& survey() const { return survey_; }
  const ParameterLayout& layout() const { return layout_; }
  TrainingState& state() { return state_; }
  const TrainingState& state() const { return state_; }

  /// Has the tables hold a slice of the next epoch; the slice behind it is read meanwhile. Nothing
  /// where all data are in memory.
  void load(int slice);
  int slice_count() const { return slice_count_; }
  std::int64_t frame_count() const;  ///< of all slices
  /// The next epoch of `stage`. What a stage needs is made at its first epoch and kept.
  /// @param should_stop  asked before every batch; may be empty
  EpochLoss train_epoch(const TrainingStage& stage, const std::function<bool()>& should_stop = {});
  /// To be called where a stage ends: its first loss is forgotten.
  void end_stage() { state_.stage_first_loss.clear(); }

  /// First frames of the windows of the slice that is loaded, for the next epoch, in their order;
  /// `count` of them are from the replay.
  std::vector<int> shuffled_starts(const TrainingStage& stage) const;
  /// Gradient and optimiser step over one batch of starts, for timing; changes nothing.
  void rehearse(const TrainingStage& stage, std::span<const int> starts);
  /// At `epochs` done, fractions counted.
  double learning_rate(double epochs) const;

  /// The networks of these N·P parameters, in `order` (all members, the leading one first).
  CompensationModel model_of(const Eigen::VectorXf& parameters, std::span<const int> order) const;
  CompensationModel model_of_member(const Eigen::VectorXf& parameters, int member) const;

 private:
  struct EpochSums {
    std::vector<double> losses;  ///< N
    std::size_t windows = 0;
  };

  void note_arms(const std::vector<int>& slice, TrainingTables& tables) const;
  EpochLoss train_slice(const TrainingStage& stage, const std::function<bool()>& should_stop,
                        EpochSums& sums);
  BatchGradient& gradient_for(const TrainingStage& stage);
  void step(double loss_scale, double rate);

  const ArmDescription& arm_;
  const TrainingSettings& settings_;
  int members_;
  SlicedEpisodes sliced_;
  std::vector<int> episode_arms_;  ///< in a family
  std::vector<int> loaded_;        ///< episodes of the slice in the tables; empty: all
  int slice_ = 0;
  int slice_count_ = 1;
  TrainingTables tables_;
  std::optional<SpilledTables> spilled_;  ///< of all slices
  DataSurvey survey_;
  ParameterLayout layout_;
  std::unique_ptr<OptimiserSteps> optimiser_;
  std::size_t replayed_;  ///< the tables' last episodes
  TrainingState state_;
  Eigen::VectorXf gradient_;
  TrainingStage gradient_stage_;
  std::unique_ptr<BatchGradient> batch_;
  std::vector<int> coming_;           ///< episodes of the slice that is being read
  std::future<TrainingTables> next_;  ///< last: it reads what is above
};

}  // namespace limber
