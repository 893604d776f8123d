#pragma once

#include <filesystem>
#include <string>

#include "epoch_trainer.hpp"

namespace limber {

/// A run between two epochs, as stored beside the model that it is to become.
struct Checkpoint {
  std::string identity;  ///< hash of data and settings: another run's checkpoint is refused
  std::vector<TrainingStage> stages;
  double elapsed_s = 0.0;
  TrainingState state;
};

/// Writes safetensors (schema limber/checkpoint/1), atomically; every number survives exactly.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// @throws InputError naming the file and what is wrong with it; also where its identity is
/// another.
Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& identity);

}  // namespace limber
