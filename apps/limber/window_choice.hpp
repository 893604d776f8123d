#pragma once

#include <filesystem>
#include <optional>

#include "limber/training/cross_validation.hpp"
#include "limber/training/stage_choice.hpp"
#include "verb.hpp"

namespace limber {

/// Where a stopped run keeps the choice that it made, so that --resume need not make it again.
std::filesystem::path choice_path_of(const std::filesystem::path& checkpoint);

/// `choose_stages` with its progress told and its result stored beside the checkpoint; on --resume
/// that file is read. None where nothing validates.
std::optional<StageChoice> choose_windows(const CommonFlags& flags, const ArmDescription& arm,
                                          const TrainingData& data, TrainingSettings& settings);

/// The file beside a run's checkpoint that keeps what its folds found.
std::filesystem::path folds_path_of(const std::filesystem::path& checkpoint);

/// `cross_validate`, or what it found before the run was stopped; says what that is.
CrossValidation choose_by_folds(const CommonFlags& flags, const ArmDescription& arm,
                                const std::vector<Episode>& episodes,
                                const TrainingSettings& settings, const IdentifiedValves& valves);

}  // namespace limber
