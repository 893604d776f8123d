#pragma once

#include <string>

#include "epoch_trainer.hpp"

namespace limber {

/// Hash of everything that decides a run's result but the stages, which a time limit may have
/// fixed; what differs there is named. A checkpoint is of one such run.
/// @param trainer  at the start, with the weights that it begins with
std::string run_identity(const ArmDescription& arm, const TrainingData& data,
                         const TrainingSettings& settings, const EpochTrainer& trainer);

/// @param begun  the stages of the checkpoint that `settings` go on from
/// @throws InputError naming both where they are another run's.
void require_same_stages(const TrainingSettings& settings, const std::vector<TrainingStage>& begun);

}  // namespace limber
