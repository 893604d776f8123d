#include "fold_choice.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace fs = std::filesystem;

fs::path folds_path_of(const fs::path& checkpoint) {
  return checkpoint.string() + ".folds.json";
}

namespace {

void write_folds(const CrossValidation& found, const fs::path& checkpoint) {
  write_file_atomically(folds_path_of(checkpoint), to_json(found).dump(2) + "\n");
}

}  // namespace

CrossValidation choose_by_folds(const CommonFlags& flags, const ArmDescription& arm,
                                const std::vector<Episode>& episodes,
                                const TrainingSettings& settings, const IdentifiedValves& valves) {
  const fs::path file = folds_path_of(settings.checkpoint);
  const bool is_there = settings.resume && fs::exists(file);
  const CrossValidation found = is_there ? read_cross_validation(read_file(file), file.string())
                                         : cross_validate(arm, episodes, settings, valves);
  if (is_there && found.identity != folds_identity(arm, episodes, settings)) {
    throw InputError(fmt::format(
        "{}: a run with other data or settings began there; give the same, or leave out --resume",
        file.string()));
  }
  if (!is_there) {
    write_folds(found, settings.checkpoint);
  }
  say(flags, "{}", to_text(found));
  return found;
}

TrainingResult train_as_found(const CommonFlags& flags, const ArmDescription& arm,
                              const std::vector<Episode>& episodes, TrainingSettings settings,
                              const IdentifiedValves& valves, CrossValidation& found) {
  TrainingResult result = train_on_everything(arm, episodes, settings, valves, found);
  while (result.status == TrainingStatus::diverged && take_another_way(found)) {
    say(flags, "{}; so it learns by {} instead, whose error is not known", result.message,
        to_string(found.best().optimiser));
    write_folds(found, settings.checkpoint);
    settings.resume = false;
    result = train_on_everything(arm, episodes, settings, valves, found);
  }
  return result;
}

}  // namespace limber
