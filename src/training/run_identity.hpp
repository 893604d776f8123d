#pragma once

#include <string>

#include "epoch_trainer.hpp"

namespace limber {

/// Hash of everything that decides a run's result but the stages, which a time limit may have
/// fixed; what differs there is named. A checkpoint is of one such run.
/// @param trainer  at the start, with the weights that it begins with
std::string run_identity(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const EpochTrainer& trainer);

}  // namespace limber
