#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// Time of the epochs of one training stage, compared with what the machine can do.
struct StageSpeed {
  int window_frames = 0;
  int windows_per_batch = 0;
  std::int64_t windows = 0;      ///< of an epoch
  double multiply_adds = 0.0;    ///< useful ones of an epoch, see `measure_training_speed`
  double epoch_s = 0.0;          ///< median: shuffling, gathering, gradients, optimiser
  double peak_gmac_per_s = 0.0;  ///< of all threads at once, mean of before and after each epoch
  double peak_difference = 0.0;  ///< largest relative difference of before and after
  double fraction_of_fma_peak = 0.0;
  double first_epoch_loss = 0.0;  ///< from the initial weights: to be compared with a peer's
};

struct TrainingSpeed {
  std::string preset;
  std::string shape;
  std::string layout;
  int networks = 1;
  int threads = 1;
  std::int64_t frames = 0;
  std::vector<StageSpeed> stages;
};

/// Times `epochs` epochs of every stage of `settings`, without validation, at a constant learning
/// rate. Useful multiply-adds are those of the layers forward and of the two products backward
/// (weights' gradients; deltas, of the first layer only for the inputs that carry the backbone over
/// from the frame before): no padding, no frame errors, no optimiser.
/// @throws InputError as `train`.
TrainingSpeed measure_training_speed(const ArmDescription& arm, const TrainingData& data,
                                     const TrainingSettings& settings, int epochs);

/// Writes what the first epoch of each stage starts from, as safetensors, so that a peer can train
/// on the same: tables, initial parameters, window starts in their order.
void write_training_tables(const fs::path& path, const ArmDescription& arm,
                           const TrainingData& data, const TrainingSettings& settings);

}  // namespace limber
