#pragma once
// For those who train and evaluate models.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "limber/common/progress.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

enum class Optimiser {
  sgd,   ///< plain stochastic gradient descent, the paper's
  adam,  ///< Kingma & Ba 2015
  /// Adam in the directions in which a weight's gradients vary (Vyas et al. 2024); one step of it
  /// teaches a family about as much as two of Adam (docs/families.md)
  soap,
};

const char* to_string(Optimiser optimiser);

/// How the errors of a batch's windows become one number. This hardly matters for Adam, but does
/// for SGD, whose step grows with the sum (docs/training.md).
enum class LossReduction { sum_over_batch, mean_over_batch };

/// What the network's numbers are scaled to over the training data; a constant column keeps
/// scale 1.
enum class Scaling {
  unit_range,   ///< [0, 1], the paper's
  unit_spread,  ///< mean 0, standard deviation 1
  /// [0, 1], with one range for poses, the no-load model's poses and what is added to them, so that
  /// an answer of 0 is the no-load model: another reading of the paper. For compensations of poses
  /// about the base alone.
  shared_range,
  /// The same with one range for all positions and one for all angles.
  range_by_unit,
};

/// What a network's weights are before training.
enum class FirstWeights {
  he,     ///< He et al. 2015, for ReLU; the last layer a tenth of that, biases zero
  torch,  ///< weights and biases uniform within ± 1 / √inputs, as PyTorch's linear layers
};

/// A part of training with windows of one length.
struct TrainingStage {
  int window_frames = 32;       ///< frames the network is rolled over, ≥ 1
  int windows_per_batch = 128;  ///< ≥ 1
  int epochs = 1;               ///< ≥ 1

  bool operator==(const TrainingStage&) const = default;
};

inline constexpr int kMaxEpochs = 10'000'000;  ///< of a run; of a stage's numbers too

/// Everything that decides a training run besides its data. Same settings, data and seed: same
/// network, for any number of jobs.
struct TrainingSettings {
  std::string preset = "best";
  BackboneLayout layout = BackboneLayout::gap_poses;
  OutputForm form = OutputForm::gated_change;
  /// Whether the network reads how the backbone moved in the frame before, as
  /// CompensationModel::reads_velocity.
  bool reads_velocity = true;
  /// Whether a network of an arm in space reads past commands (docs/space.md), as
  /// CompensationModel::past_commands. In a plane none does.
  bool reads_past_commands = true;
  std::vector<int> hidden_units = {100, 100, 100};
  Scaling scaling = Scaling::unit_spread;
  /// If true, frame errors are taken over poses about the base, whatever the layout; otherwise over
  /// the network's own numbers. The two are the same for base_poses.
  bool error_in_base_poses = true;
  /// If true, frame errors are in metres and radians; otherwise in units of the spread that
  /// compensation has in each number.
  bool error_in_user_units = false;
  FirstWeights first_weights = FirstWeights::he;
  /// Whether gaps stay within what was recorded of them (GapBounds), in training and afterwards.
  bool bounded = true;
  LossReduction reduction = LossReduction::mean_over_batch;
  std::vector<TrainingStage> stages;

  Optimiser optimiser = Optimiser::adam;
  double learning_rate = 3e-3;     ///< 6e-3 learns faster, but Adam sometimes diverges
  bool cosine_decay = true;        ///< towards zero over the whole run, otherwise constant
  double gradient_norm_limit = 0;  ///< longer gradients are shortened to this; 0: never
  /// The gradient that a window carries back to a frame is shortened to this many times the sum of
  /// what later frames put in: networks that read velocities may otherwise begin to amplify, and
  /// then nothing is learnt any more. 0: never.
  double growth_limit = 0;
  /// A window's frame k (from 0) counts (k + 1)^-power: errors grow along a window, so that without
  /// this the last frames decide, and one step ahead is learnt late. 0: all count alike.
  double first_frames_power = 0;
  /// Every step shortens the network's weights and biases by this times the learning rate, the
  /// vectors of a family's arms excepted (Loshchilov & Hutter 2019). 0: no step does.
  double weight_decay = 0;
  bool shift_windows = true;  ///< each epoch cuts its windows at another offset

  /// k, numbers that say which of a family's arms it is (network/arm_family.hpp), 0 to 64; 0: the
  /// network is one arm's.
  int family_size = 0;

  int ensemble = 1;            ///< networks trained together, 1 to 64, each from its own weights
  double replay_share = 0.25;  ///< of an epoch's windows, from what is replayed; [0, 0.95]

  std::uint64_t seed = 1;
  int jobs = 0;  ///< threads, 0: one per core; never changes a result
  /// > 0: the epochs of every stage are scaled to about this, once, at the start.
  double time_limit_s = 0;
  int validation_interval = 1;  ///< epochs between validations
  /// > 0: training ends after this epoch, whose network is kept; nothing may validate then.
  int keep_epoch = 0;
  Progress::Mode progress = Progress::Mode::quiet;

  /// File in which the run is stored now and then, when it is interrupted and when it has finished.
  /// The code that stores the result removes this file. Empty: none.
  std::filesystem::path checkpoint;
  double checkpoint_interval_s = 20.0;  ///< between storing, at least
  int stop_after_epochs = 0;            ///< > 0: stop there as if interrupted
  bool resume = false;  ///< go on from that file; the result has the bits of an unbroken run

  int epoch_count() const;
};

/// The paper's training (V-3): base poses in [0, 1], 3 × 100 ReLU, batches of 128 windows of 32
/// frames, SGD at 1e-4 on the summed loss, 6000 epochs; and a limit that catches exploding
/// gradients.
TrainingSettings paper_preset();

/// The default: a gated change of plate-relative poses, one layer of 200 units, SOAP with cosine
/// decay and weight decay, windows of 32 frames of which the first ones count most.
TrainingSettings best_preset();

/// @throws InputError naming the known presets.
TrainingSettings training_preset(const std::string& name);

/// Scales the stages to `epochs` in all, keeping their proportions; each keeps at least one.
/// @throws InputError if there are fewer epochs than stages.
void set_epoch_count(TrainingSettings& settings, int epochs);

/// Replaces the stages by windows of these lengths, in this order, which share the epochs.
/// @param window_frames  one per stage, each ≥ 1
/// @throws InputError if there is none, one is < 1, or there are fewer epochs than stages.
void set_window_frames(TrainingSettings& settings, const std::vector<int>& window_frames);

/// Where they say SOAP: Adam, without weight decay, and all frames of a window count alike.
void take_adam_for_soap(TrainingSettings& settings);

/// For a family of arms (docs/families.md) that so many numbers tell apart: three layers of 100
/// units, trained by SOAP with weight decay, in windows of 32 frames, all of which count alike, and
/// validated every 25 epochs, since every arm held back is fitted then.
void set_family_size(TrainingSettings& settings, int size);

/// The settings with layout, output, hidden units and number of networks of `model`.
TrainingSettings in_form_of(const CompensationModel& model, TrainingSettings settings);

/// @throws InputError naming the setting, what it is and what is allowed.
void require_usable(const TrainingSettings& settings);

}  // namespace limber
