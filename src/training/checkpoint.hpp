#pragma once

#include <filesystem>
#include <string>

#include "epoch_trainer.hpp"
#include "limber/common/filesystem.hpp"

namespace limber {

/// A run between two epochs, stored beside the model that it will become.
struct Checkpoint {
  std::string identity;  ///< hash of data and settings: another run's checkpoint is refused
  std::vector<TrainingStage> stages;
  double elapsed_s = 0.0;
  TrainingState state;
};

/// What a run's checkpoint must contain; anything else means damage.
struct RunShape {
  Eigen::Index parameters = 0;  ///< of all networks together
  int members = 1;              ///< networks
  bool keeps_moments = false;   ///< of the gradient
  Eigen::Index rotations = 0;   ///< SOAP's numbers
  bool validates = true;        ///< on data held back
};

/// Writes safetensors (schema limber/checkpoint/5), atomically; every number survives exactly.
void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint);

/// Reads, and checks everything that training needs: sizes, ranges, finite numbers, and that the
/// parts agree with each other. @throws InputError naming the file and what is wrong with it, also
/// if it has another identity.
Checkpoint read_checkpoint(const fs::path& path, const std::string& identity, const RunShape& run);

}  // namespace limber
