#include "limber/training/fine_tuning.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kEpochShare = 2;
constexpr double kRateShare = 0.1;
constexpr int kLeastFrames = 3;  // `evaluate` needs as many

std::optional<FineTuningReport::Change> change_on(const ForwardModel& no_load,
                                                  const ForwardModel& before,
                                                  const ForwardModel& after,
                                                  const std::vector<Episode>& episodes, int jobs) {
  const bool long_enough = std::ranges::any_of(episodes, [](const Episode& episode) {
    return episode.frame_count() >= kLeastFrames &&
           episode.untracked_count() < episode.frame_count();
  });
  if (!long_enough) {
    return std::nullopt;
  }
  return FineTuningReport::Change{*evaluate(no_load, &before, episodes, jobs).network,
                                  *evaluate(no_load, &after, episodes, jobs).network};
}

Json to_json(const RolloutErrors& errors) {
  return {{"one_step", tip_errors_to_json(errors.one_step)},
          {"window_32", tip_errors_to_json(errors.window_32)},
          {"per_motion", tip_errors_to_json(errors.per_motion)},
          {"open_loop", tip_errors_to_json(errors.open_loop)}};
}

Json to_json(const std::optional<FineTuningReport::Change>& change) {
  return change ? Json{{"before", to_json(change->before)}, {"after", to_json(change->after)}}
                : Json();
}

std::string row(const char* name, const RolloutErrors& errors) {
  return fmt::format("{:<24} {:8.2f} {:9.2f} {:10.2f} {:9.2f}\n", name,
                     errors.one_step.position_cm.mean, errors.window_32.position_cm.mean,
                     errors.per_motion.position_cm.mean, errors.open_loop.position_cm.mean);
}

}  // namespace

TrainingSettings fine_tuning_of(TrainingSettings preset) {
  if (!preset.stages.empty()) {
    preset.stages.erase(preset.stages.begin(), preset.stages.end() - 1);
    preset.stages.front().epochs = std::max(preset.stages.front().epochs / kEpochShare, 1);
  }
  preset.learning_rate *= kRateShare;
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

Json to_json(const FineTuningReport& report) {
  return {{"new_data", to_json(report.new_data)}, {"old_data", to_json(report.old_data)}};
}

std::string to_text(const FineTuningReport& report) {
  std::string text = fmt::format("{:<24} {:>8} {:>9} {:>10} {:>9}\n", "tip error [cm], held back",
                                 "one step", "32 frames", "per motion", "open loop");
  if (report.new_data) {
    text += row("new data, before", report.new_data->before);
    text += row("new data, after", report.new_data->after);
  }
  if (report.old_data) {
    text += row("old data, before", report.old_data->before);
    text += row("old data, after", report.old_data->after);
  }
  return text;
}

}  // namespace limber
