#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "episode_choice.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/training/cross_validation.hpp"
#include "limber/training/fine_tuning.hpp"
#include "verb.hpp"

namespace limber {

/// What `limber train --from M --epochs 0` is told.
struct BoundModelRequest {
  std::string arm;
  std::string from;
  std::vector<std::string> data;
  std::vector<std::string> old_data;
  std::string out;
};

/// Gives the model `from` the bounds of (20) that these recordings have, and writes it to `out`;
/// nothing else in it changes. Bounds that it had are widened. Gives the exit code.
/// @throws InputError if a file is missing, broken or of another arm.
int add_bounds_to_model(const BoundModelRequest& request, const CommonFlags& flags);

/// What a training run wrote.
struct TrainingFiles {
  std::string model;
  fs::path learning_curve;
};

/// Which episodes are left out as broken, and why.
void say_broken(const CommonFlags& flags, const EpisodeChoice& choice);
/// That nothing is held back, and why.
void say_little(const CommonFlags& flags, const ArmDescription& arm,
                const std::vector<Episode>& episodes);
/// Which episodes choose the best epoch, and which are broken.
void say_episodes(const CommonFlags& flags, const EpisodeChoice& choice);
/// What is trained, on how much, for how long.
void say_training(const CommonFlags& flags, const TrainingData& data,
                  const TrainingSettings& settings);
/// Prints that no epoch was validated, and why.
void print_no_model(const CommonFlags& flags, const TrainingResult& result);
/// Prints what `train` found: one JSON object, or lines for people.
/// @param folds  what said for how long to train; none where validation did
void print_training_result(const CommonFlags& flags, const ArmDescription& arm,
                           const TrainingFiles& files, const TrainingResult& result,
                           const std::optional<FineTuningReport>& changes,
                           const EpisodeChoice& choice,
                           const std::optional<CrossValidation>& folds);

}  // namespace limber
