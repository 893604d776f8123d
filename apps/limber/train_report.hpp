#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "episode_choice.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/stage_choice.hpp"
#include "verb.hpp"

namespace limber {

/// What a training run wrote.
struct TrainingFiles {
  std::string model;
  std::filesystem::path learning_curve;
};

/// Prints what `train` found: one JSON object, or lines for people.
void print_training_result(const CommonFlags& flags, const Command& command,
                           const TrainingFiles& files, const TrainingResult& result,
                           const std::optional<FineTuningReport>& changes,
                           const EpisodeChoice& choice, const std::optional<StageChoice>& stages);

}  // namespace limber
