#pragma once

#include <vector>

#include "limber/training/trainer.hpp"

namespace limber {

/// Frames of the windows that the default preset learns from, where nothing says how to train:
/// over long rollouts and unseen data they are ahead of shorter ones (docs/training.md).
inline constexpr int kUsualWindowFrames = 32;

/// Networks among which the default preset shares its epochs: 3 where `data` trains on 1 to 4 hours
/// of motion, since there three arrive more often than one (docs/training.md, Ensembles); else 1.
int network_count_for(const ArmDescription& arm, const TrainingData& data);

/// Trains `networks` together, in the time of one: each gets its share of the epochs, and at least
/// one for each stage.
void share_epochs(TrainingSettings& settings, int networks);

/// Frames per window of each stage.
std::vector<int> windows_of(const TrainingSettings& settings);

}  // namespace limber
