#pragma once

#include <filesystem>
#include <optional>

#include "limber/training/stage_choice.hpp"
#include "verb.hpp"

namespace limber {

/// Where a stopped run keeps the choice that it made, so that --resume need not make it again.
std::filesystem::path choice_path_of(const std::filesystem::path& checkpoint);

/// `choose_stages` with its progress told and its result stored beside the checkpoint; on --resume
/// that file is read. None where nothing validates.
std::optional<StageChoice> choose_windows(const CommonFlags& flags, const ArmDescription& arm,
                                          const TrainingData& data, TrainingSettings& settings);

}  // namespace limber
