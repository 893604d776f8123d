#include "limber/training/stage_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "learnt_kind.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/data/episode_slice.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr int kLongFrames = 600;  // as `train` validates
constexpr int kMidFrames = 32;

// A short run takes about so many frames, 2000 to 4000 batches: enough to tell windows apart. With
// much data that is few epochs.
constexpr double kRaceFrames = 2e6;
constexpr int kMinRaceEpochs = 10;
constexpr int kMaxRaceShare = 10;  // of the epochs, for each run: 1/10

// Between these, three networks were measured to arrive more often than one (docs/training.md).
constexpr double kMinHoursToShare = 1.0;
constexpr double kMaxHoursToShare = 4.0;
constexpr int kNetworksThatShare = 3;

int race_epochs(const TrainingData& data, int epochs) {
  const int wanted = static_cast<int>(
      std::lround(kRaceFrames / std::max(double(frame_count(data.training)), 1.0)));
  return std::clamp(wanted, kMinRaceEpochs, std::max(epochs / kMaxRaceShare, kMinRaceEpochs));
}

void set_windows(TrainingSettings& settings, const std::vector<int>& preset,
                 const std::vector<int>& windows) {
  if (windows != preset) {
    set_window_frames(settings, windows);
  }
}

/// A short run, of one network, in memory alone.
WindowsTried raced(const ArmDescription& arm, const TrainingData& data, TrainingSettings settings,
                   const std::vector<int>& windows, int epochs, const TrainingHooks& hooks) {
  set_windows(settings, windows_of(settings), windows);
  set_epoch_count(settings, epochs);
  settings.ensemble = 1;
  settings.checkpoint.clear();
  settings.resume = false;
  settings.progress = Progress::Mode::quiet;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  WindowsTried tried{windows, kInfinite, kInfinite, kInfinite};
  const TrainingResult result = train(arm, data, settings, hooks);
  throw_if_interrupted();
  if (result.status == TrainingStatus::interrupted) {
    throw Interrupted("stopped while windows were tried");
  }
  if (result.best_epoch > 0) {
    const ForwardModel model(arm, result.model);
    tried.one_step_cm = tip_error_cm(model, data.validation, 1, settings.jobs);
    tried.window_32_cm = tip_error_cm(model, data.validation, kMidFrames, settings.jobs);
    tried.window_600_cm = tip_error_cm(model, data.validation, kLongFrames, settings.jobs);
  }
  return tried;
}

}  // namespace

std::vector<int> windows_of(const TrainingSettings& settings) {
  std::vector<int> frames;
  for (const TrainingStage& stage : settings.stages) {
    frames.push_back(stage.window_frames);
  }
  return frames;
}

StageChoice choose_stages(const ArmDescription& arm, const TrainingData& data,
                          TrainingSettings& settings, const TrainingHooks& hooks) {
  if (data.validation.empty()) {
    throw InputError(
        "no validation episodes to choose windows by; hold_back_validation holds some back");
  }
  require_data_of(data, arm);
  StageChoice choice;
  choice.race_epochs = race_epochs(data, settings.epoch_count());
  const std::vector<std::vector<int>> schemes = {{32}, {8, 32}, windows_of(settings)};
  for (const std::vector<int>& windows : schemes) {
    choice.tried.push_back(raced(arm, data, settings, windows, choice.race_epochs, hooks));
  }
  choice.epochs = settings.epoch_count() - static_cast<int>(schemes.size()) * choice.race_epochs;
  const auto best = std::ranges::min_element(choice.tried, {},
                                             [](const WindowsTried& t) { return t.score_cm(); });
  if (best->score_cm() < (1.0 - kClearlyBetter) * choice.tried.front().score_cm()) {
    choice.chosen = static_cast<int>(best - choice.tried.begin());
  }
  apply(choice, settings);
  return choice;
}

void apply(const StageChoice& choice, TrainingSettings& settings) {
  set_windows(settings, windows_of(settings),
              choice.tried[static_cast<std::size_t>(choice.chosen)].window_frames);
  set_epoch_count(settings, choice.epochs);
}

int network_count_for(const ArmDescription& arm, const TrainingData& data) {
  const double hours = double(frame_count(data.training)) * arm.frame_period_s() / 3600.0;
  return hours >= kMinHoursToShare && hours <= kMaxHoursToShare ? kNetworksThatShare : 1;
}

void share_epochs(TrainingSettings& settings, int networks) {
  settings.ensemble = networks;
  const int stages = static_cast<int>(settings.stages.size());
  set_epoch_count(settings, std::max(settings.epoch_count() / networks, stages));
}

nlohmann::ordered_json to_json(const StageChoice& choice) {
  nlohmann::ordered_json json = {
      {"windows", choice.tried[static_cast<std::size_t>(choice.chosen)].window_frames},
      {"epochs", choice.epochs},
      {"race_epochs", choice.race_epochs},
      {"tried", nlohmann::ordered_json::array()}};
  for (const WindowsTried& tried : choice.tried) {
    json["tried"].push_back({{"windows", tried.window_frames},
                             {"score_cm", json_number(tried.score_cm())},
                             {"one_step_cm", json_number(tried.one_step_cm)},
                             {"window_32_cm", json_number(tried.window_32_cm)},
                             {"window_600_cm", json_number(tried.window_600_cm)}});
  }
  return json;
}

std::string to_text(const StageChoice& choice) {
  std::string text;
  for (std::size_t i = 0; i < choice.tried.size(); ++i) {
    const WindowsTried& tried = choice.tried[i];
    text += fmt::format("{}{}: {:.3g} cm{}", text.empty() ? "" : "; ",
                        fmt::join(tried.window_frames, " "), tried.score_cm(),
                        static_cast<int>(i) == choice.chosen ? ", chosen" : "");
  }
  return text;
}

void write_choice(const std::filesystem::path& path, const StageChoice& choice) {
  write_file_atomically(path, to_json(choice).dump(2) + "\n");
}

StageChoice read_choice(const std::filesystem::path& path) {
  constexpr int kMaxEpochs = 10'000'000;
  const std::string where = path.string();
  const nlohmann::json json = parse_json_object(read_file(path), where);
  const JsonReader root(json, where, "");
  StageChoice choice;
  choice.race_epochs = root.at("race_epochs").integer(1, kMaxEpochs);
  choice.epochs = root.at("epochs").integer(1, kMaxEpochs);
  const auto windows_at = [&](const JsonReader& field) {
    std::vector<int> windows;
    for (const JsonReader& item : field.elements("a list of frames")) {
      windows.push_back(item.integer(1, kMaxEpochs));
    }
    return windows;
  };
  const auto error_at = [](const JsonReader& field) {
    return field.is_null() ? std::numeric_limits<double>::infinity() : field.number(0.0);
  };
  const std::vector<int> chosen = windows_at(root.at("windows"));
  choice.chosen = -1;
  for (const JsonReader& row : root.at("tried").elements("a list of runs")) {
    choice.tried.push_back({windows_at(row.at("windows")), error_at(row.at("one_step_cm")),
                            error_at(row.at("window_32_cm")), error_at(row.at("window_600_cm"))});
    if (choice.tried.back().window_frames == chosen) {
      choice.chosen = static_cast<int>(choice.tried.size()) - 1;
    }
  }
  if (choice.chosen < 0) {
    root.at("windows").refuse("these windows were not tried; remove the file and train again");
  }
  return choice;
}

}  // namespace limber
