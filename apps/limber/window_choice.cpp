#include "window_choice.hpp"

namespace limber {

namespace fs = std::filesystem;

fs::path choice_path_of(const fs::path& checkpoint) {
  return checkpoint.string() + ".windows.json";
}

std::optional<StageChoice> choose_windows(const CommonFlags& flags, const ArmDescription& arm,
                                          const TrainingData& data, TrainingSettings& settings) {
  if (data.validation.empty()) {
    return std::nullopt;
  }
  const fs::path file = choice_path_of(settings.checkpoint);
  if (settings.resume && fs::exists(file)) {
    const StageChoice choice = read_choice(file);
    apply(choice, settings);
    return choice;
  }
  say(flags, "choosing windows by short runs; --windows and --epochs make no choice");
  const StageChoice choice = choose_stages(arm, data, settings);
  write_choice(file, choice);
  say(flags, "windows and their validation errors after {} epochs: {}", choice.race_epochs,
      to_text(choice));
  return choice;
}

}  // namespace limber
