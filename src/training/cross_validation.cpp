#include "limber/training/cross_validation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/training/run_errors.hpp"
#include "limber/training/unseen_error.hpp"
#include "rollout.hpp"
#include "shuffle.hpp"

namespace limber {

namespace {

constexpr double kMaxHours = 1.0;  // with more, a tenth held back costs less than it tells
constexpr int kLittleWindowFrames = 32;
constexpr double kFirstFramesPower = 1.5;
constexpr std::uint64_t kFoldStream = 0x666f6c6473;
constexpr int kMinPartFrames = 100;  // a rollout over less says little

/// What is tried: a wide layer, which learns little of the noise, and the preset's three, of the
/// number of epochs that they need where recordings are clean; or the user's layers.
std::vector<EpochsTried> tries(const std::vector<int>& hidden_units) {
  if (hidden_units.empty()) {
    return {{100, {200}}, {300, {200}}, {300, TrainingSettings().hidden_units}};
  }
  return {{100, hidden_units}, {300, hidden_units}};
}

/// The parts that folds are made of, and what is learnt from in all of them.
struct Parts {
  std::vector<Episode> moving;
  std::vector<Episode> resting;
};

/// Whether a rollout over it says anything: it moves, was seen, and is longer than a window.
bool can_judge(const ArmDescription& arm, const Episode& episode) {
  return episode.frame_count() > kLittleWindowFrames + 1 &&
         episode.frame_count() - episode.untracked_count() >= 2 && moves(arm, episode);
}

Parts parts_of(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  Parts parts;
  for (const Episode& episode : episodes) {
    (can_judge(arm, episode) ? parts.moving : parts.resting).push_back(episode);
  }
  while (!parts.moving.empty() && parts.moving.size() < 2 * kFolds) {
    Episode& longest = *std::ranges::max_element(parts.moving, {}, &Episode::frame_count);
    const int frames = longest.frame_count();
    if (frames < 2 * kMinPartFrames) {
      break;
    }
    Episode rest = slice(longest, frames / 2, frames - frames / 2);
    longest = slice(longest, 0, frames / 2);
    parts.moving.push_back(std::move(rest));
  }
  const auto judging = std::stable_partition(
      parts.moving.begin(), parts.moving.end(),
      [&](const Episode& part) { return can_judge(arm, part); });  // a half may rest
  std::move(judging, parts.moving.end(), std::back_inserter(parts.resting));
  parts.moving.erase(judging, parts.moving.end());
  return parts;
}

/// The fold of each part: the longest ones first, each to the fold that has least.
std::vector<int> deal(const std::vector<Episode>& parts, std::uint64_t seed) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random(seed, kFoldStream);
  shuffle(random, order);
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t i) { return parts[i].frame_count(); });
  std::array<int, kFolds> frames{};
  std::vector<int> folds(parts.size());
  for (const std::size_t i : order) {
    const auto least = std::ranges::min_element(frames);
    folds[i] = static_cast<int>(least - frames.begin());
    *least += parts[i].frame_count();
  }
  return folds;
}

class CrossValidator {
 public:
  CrossValidator(const ArmDescription& arm, const std::vector<Episode>& episodes,
                 const TrainingSettings& settings, const IdentifiedValves& valves,
                 const TrainingHooks& hooks)
      : arm_(arm),
        parts_(parts_of(arm, episodes)),
        fold_(deal(parts_.moving, settings.seed)),
        settings_(settings),
        valves_(valves),
        hooks_(hooks) {
    if (parts_.moving.size() < kFolds) {
      throw InputError(fmt::format(
          "{} parts of more than {} frames in which the arm moves; {} folds need one each. Give "
          "more of its motion, or a recording of its own that validates",
          parts_.moving.size(), kLittleWindowFrames + 1, kFolds));
    }
    settings_.checkpoint.clear();
    settings_.resume = false;
    settings_.ensemble = 1;
  }

  CrossValidation run() {
    CrossValidation found;
    found.folds = kFolds;
    for (const EpochsTried& next : tries(settings_.hidden_units)) {
      RunErrors errors;
      found.tried.push_back(tried(next, errors));
      if (found.tried.size() == 1 || found.tried.back().score_cm() < found.best().score_cm()) {
        found.chosen = static_cast<int>(found.tried.size()) - 1;
        found.prediction_error = errors.result(arm_.frame_period_s());
        if (!arm_.is_spatial()) {  // which can't be planned for yet
          found.tube = errors.tube(arm_.length_m());
          found.widest_where = errors.widest_where(arm_.command.unit);
        }
      }
    }
    if (!std::isfinite(found.best().score_cm())) {
      throw InputError(
          fmt::format("no network of cross-validation predicts finite shapes: {}",
                      message_.empty() ? "look at the data with limber inspect" : message_));
    }
    return found;
  }

 private:
  /// A network for each fold, and what they are worth together.
  EpochsTried tried(EpochsTried sum, RunErrors& errors) {
    set_epoch_count(settings_, sum.epochs);
    settings_.keep_epoch = sum.epochs;
    settings_.hidden_units = sum.hidden_units;
    for (int fold = 0; fold < kFolds; ++fold) {
      TrainingData data;
      data.training = parts_.resting;
      std::vector<Episode> unseen;
      for (std::size_t i = 0; i < parts_.moving.size(); ++i) {
        (fold_[i] == fold ? unseen : data.training).push_back(parts_.moving[i]);
      }
      TrainingResult trained = train(arm_, data, settings_, hooks_);
      if (trained.status == TrainingStatus::interrupted) {
        throw Interrupted("stopped while cross-validation looked for the number of epochs");
      }
      trained.model.set_valves(valves_);
      if (trained.status != TrainingStatus::finished ||
          !errors.add(arm_, trained.model, unseen, settings_.jobs)) {
        message_ = trained.message;
        return {sum.epochs, sum.hidden_units, kNever, kNever, kNever};
      }
      const ForwardModel model(arm_, std::move(trained.model));
      const double share = double(frame_count(unseen)) / double(frame_count(parts_.moving));
      sum.one_step_cm += share * tip_error_cm(model, unseen, 1, settings_.jobs);
      sum.window_32_cm += share * tip_error_cm(model, unseen, 32, settings_.jobs);
      sum.window_600_cm += share * tip_error_cm(model, unseen, 600, settings_.jobs);
      throw_if_interrupted();
    }
    return sum;
  }

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  const ArmDescription& arm_;
  Parts parts_;
  std::vector<int> fold_;  // of each moving part
  TrainingSettings settings_;
  const IdentifiedValves& valves_;
  const TrainingHooks& hooks_;
  std::string message_;  // of a run that diverged
};

}  // namespace

bool is_little(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  constexpr double kSecondsPerHour = 3600.0;
  return double(frame_count(episodes)) * arm.frame_period_s() <= kMaxHours * kSecondsPerHour &&
         parts_of(arm, episodes).moving.size() >= kFolds;
}

TrainingSettings preset_for_little() {
  TrainingSettings settings = best_preset();
  set_window_frames(settings, {kLittleWindowFrames});
  settings.first_frames_power = kFirstFramesPower;
  settings.hidden_units.clear();
  return settings;
}

CrossValidation cross_validate(const ArmDescription& arm, const std::vector<Episode>& episodes,
                               const TrainingSettings& settings, const IdentifiedValves& valves,
                               const TrainingHooks& hooks) {
  return CrossValidator(arm, episodes, settings, valves, hooks).run();
}

TrainingResult train_on_everything(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                   const TrainingSettings& settings, const IdentifiedValves& valves,
                                   const CrossValidation& found, const TrainingHooks& hooks) {
  TrainingData data;
  data.training = episodes;
  TrainingSettings all = settings;
  set_epoch_count(all, found.epochs());
  all.hidden_units = found.best().hidden_units;
  all.keep_epoch = found.epochs();
  TrainingResult result = train(arm, data, all, hooks);
  if (result.best_epoch > 0) {
    result.model.set_valves(valves);
    if (!arm.is_spatial()) {
      result.model.learnt = learnt_region_of(data);
    }
    if (result.status == TrainingStatus::finished && result.best_epoch == found.epochs()) {
      result.model.prediction_error = found.prediction_error;
      result.model.tube = found.tube;
    }
    note_shapes(arm, result.model, episodes, settings.jobs);
  }
  return result;
}

nlohmann::ordered_json to_json(const CrossValidation& found) {
  nlohmann::ordered_json json = {{"folds", found.folds},
                                 {"epochs", found.epochs()},
                                 {"hidden_units", found.best().hidden_units},
                                 {"tried", nlohmann::ordered_json::array()},
                                 {"prediction_error", nullptr},
                                 {"tube", nullptr},
                                 {"widest_where", found.widest_where}};
  for (const EpochsTried& tried : found.tried) {
    json["tried"].push_back({{"epochs", tried.epochs},
                             {"hidden_units", tried.hidden_units},
                             {"one_step_cm", json_number(tried.one_step_cm)},
                             {"window_32_cm", json_number(tried.window_32_cm)},
                             {"window_600_cm", json_number(tried.window_600_cm)}});
  }
  if (found.prediction_error) {
    json["prediction_error"] =
        nlohmann::ordered_json::parse(prediction_error_to_metadata(*found.prediction_error));
  }
  if (found.tube) {
    json["tube"] = nlohmann::ordered_json::parse(tube_to_metadata(*found.tube));
  }
  return json;
}

namespace {

std::vector<int> hidden_units_at(const JsonReader& row) {
  constexpr int kMaxUnits = 4096;
  std::vector<int> units;
  for (const JsonReader& layer : row.at("hidden_units").elements("units of each hidden layer")) {
    units.push_back(layer.integer(1, kMaxUnits));
  }
  return units;
}

}  // namespace

CrossValidation read_cross_validation(const std::string& text, const std::string& where) {
  constexpr int kMaxEpochs = 10'000'000;
  const nlohmann::json json = parse_json_object(text, where);
  const JsonReader root(json, where, "");
  CrossValidation found;
  found.folds = root.at("folds").integer(1, kFolds);
  const int epochs = root.at("epochs").integer(1, kMaxEpochs);
  const std::vector<int> hidden_units = hidden_units_at(root);
  found.chosen = -1;
  for (const JsonReader& row : root.at("tried").elements("a list of runs")) {
    const auto error_at = [&](const char* key) {
      const JsonReader field = row.at(key);
      return field.is_null() ? std::numeric_limits<double>::infinity() : field.number(0.0);
    };
    found.tried.push_back({row.at("epochs").integer(1, kMaxEpochs), hidden_units_at(row),
                           error_at("one_step_cm"), error_at("window_32_cm"),
                           error_at("window_600_cm")});
    if (found.tried.back().epochs == epochs && found.tried.back().hidden_units == hidden_units) {
      found.chosen = static_cast<int>(found.tried.size()) - 1;
    }
  }
  if (found.chosen < 0) {
    root.at("epochs").refuse("so many were not tried; remove the file and train again");
  }
  if (const JsonReader error = root.at("prediction_error"); !error.is_null()) {
    found.prediction_error = read_prediction_error(
        YamlReader::from_text(error.value().dump(), where + ": prediction_error"));
  }
  found.widest_where = root.at("widest_where").text();
  if (const JsonReader tube = root.at("tube"); !tube.is_null()) {
    found.tube = read_tube(YamlReader::from_text(tube.value().dump(), where + ": tube"));
  }
  return found;
}

std::string to_text(const CrossValidation& found) {
  std::string text = fmt::format(
      "{} networks each, on episodes that they had not seen (one step, 32, up to 600 frames)",
      found.folds);
  for (std::size_t i = 0; i < found.tried.size(); ++i) {
    const EpochsTried& tried = found.tried[i];
    text += fmt::format("{} {} epochs of {}: {:.2f}, {:.2f}, {:.2f} cm{}", i == 0 ? ":" : ";",
                        tried.epochs, fmt::join(tried.hidden_units, "-"), tried.one_step_cm,
                        tried.window_32_cm, tried.window_600_cm,
                        static_cast<int>(i) == found.chosen ? ", chosen" : "");
  }
  return text;
}

}  // namespace limber
