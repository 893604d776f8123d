#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/training/trainer.hpp"

namespace limber {

/// Windows of a training run's stages, and how a short run with them did.
struct WindowsTried {
  std::vector<int> window_frames;
  /// Mean tip errors on the validation data of the run's best epoch: one step ahead, and over
  /// rollouts of 32 and of up to 600 frames. Infinite if the run diverged.
  double one_step_cm = 0.0;
  double window_32_cm = 0.0;
  double window_600_cm = 0.0;

  /// What decides: the mean, as of factors, of the errors over 32 and 600 frames. The latter alone
  /// hangs on the few episodes that go astray. Over one frame, and after few epochs, short windows
  /// are ahead even where they end behind.
  double score_cm() const { return std::sqrt(window_32_cm * window_600_cm); }
};

/// What a race between windows found.
struct StageChoice {
  std::vector<WindowsTried> tried;  ///< windows of 32 alone first, the preset's last
  int chosen = 0;                   ///< index in `tried`
  int race_epochs = 0;              ///< of each short run
  int epochs = 0;                   ///< left for the chosen windows
};

/// Chooses the windows of `settings` (the default preset's) by validation: a short run for each of
/// 32 alone, 8 then 32, and the preset's windows; 32 alone is taken unless others are better by
/// kClearlyBetter, since it gains most from the epochs that follow. Leaves in `settings` the chosen
/// stages and the epochs that the race did not use, so that both together take no longer than the
/// preset alone. Depends on data, settings and seed, not on threads.
/// @param hooks  of the short runs
/// @throws InputError without validation data, and as `train`; Interrupted on Ctrl-C, or where
/// hooks.should_stop says so.
StageChoice choose_stages(const ArmDescription& arm, const TrainingData& data,
                          TrainingSettings& settings, const TrainingHooks& hooks = {});
inline constexpr double kClearlyBetter = 0.25;

/// The stages of `choice`, for `settings` as they were before it was made.
void apply(const StageChoice& choice, TrainingSettings& settings);

/// Networks among which the default preset shares its epochs: 3 where `data` trains on 1 to 4 hours
/// of motion, since there three arrive more often than one (docs/training.md, Ensembles); else 1.
int network_count_for(const ArmDescription& arm, const TrainingData& data);

/// Trains `networks` together, in the time of one: each gets its share of the epochs, and at least
/// one for each stage.
void share_epochs(TrainingSettings& settings, int networks);

/// Frames per window of each stage.
std::vector<int> windows_of(const TrainingSettings& settings);

/// The object `windows_choice` of `train --json`, and of the file that lets a stopped run go on.
nlohmann::ordered_json to_json(const StageChoice& choice);
/// For people, and for the model's record: "2 8 32: 4.06 cm; 8 32: 3.72 cm; 32: 3.59 cm, chosen".
std::string to_text(const StageChoice& choice);

/// The choice as a file beside a run's checkpoint.
void write_choice(const std::filesystem::path& path, const StageChoice& choice);
/// @throws InputError naming the file and what is wrong with it.
StageChoice read_choice(const std::filesystem::path& path);

}  // namespace limber
