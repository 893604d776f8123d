#pragma once

#include <filesystem>

#include "limber/training/cross_validation.hpp"
#include "verb.hpp"

namespace limber {

/// The file beside a run's checkpoint that keeps what its folds found.
std::filesystem::path folds_path_of(const std::filesystem::path& checkpoint);

/// `cross_validate`, or what it found before the run was stopped; says what that is.
CrossValidation choose_by_folds(const CommonFlags& flags, const ArmDescription& arm,
                                const std::vector<Episode>& episodes,
                                const TrainingSettings& settings, const IdentifiedValves& valves);

/// `train_on_everything`; where a way diverges, by the next, which is said and kept for --resume.
TrainingResult train_as_found(const CommonFlags& flags, const ArmDescription& arm,
                              const std::vector<Episode>& episodes, TrainingSettings settings,
                              const IdentifiedValves& valves, CrossValidation& found);

}  // namespace limber
