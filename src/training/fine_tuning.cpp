#include "limber/training/fine_tuning.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kEpochShare = 2;
constexpr double kRateShare = 0.1;
constexpr int kMinEpisodeFrames = 3;  // `evaluate` needs as many

std::optional<FineTuningReport::Change> change_on(const ForwardModel& no_load,
                                                  const ForwardModel& before,
                                                  const ForwardModel& after,
                                                  const std::vector<Episode>& episodes, int jobs) {
  const bool long_enough = std::ranges::any_of(episodes, [](const Episode& episode) {
    return episode.frame_count() >= kMinEpisodeFrames &&
           episode.untracked_count() < episode.frame_count();
  });
  if (!long_enough) {
    return std::nullopt;
  }
  return FineTuningReport::Change{*evaluate(no_load, &before, episodes, jobs).network,
                                  *evaluate(no_load, &after, episodes, jobs).network};
}

}  // namespace

TrainingSettings fine_tuning_of(TrainingSettings preset) {
  if (!preset.stages.empty()) {
    preset.stages.erase(preset.stages.begin(), preset.stages.end() - 1);
    preset.stages.front().epochs = std::max(preset.stages.front().epochs / kEpochShare, 1);
  }
  preset.learning_rate *= kRateShare;
  // In so few steps SOAP hardly learns its directions; an arm outside its family came out worse.
  take_adam_for_soap(preset);
  return preset;
}

FineTuningReport compare_models(const ArmDescription& arm, const CompensationModel& before,
                                const CompensationModel& after,
                                const std::vector<Episode>& new_data,
                                const std::vector<Episode>& old_data, int jobs) {
  const ForwardModel no_load(arm);
  const ForwardModel model_before(arm, before);
  const ForwardModel model_after(arm, after);
  return {change_on(no_load, model_before, model_after, new_data, jobs),
          change_on(no_load, model_before, model_after, old_data, jobs)};
}

}  // namespace limber
