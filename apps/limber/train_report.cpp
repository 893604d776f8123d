#include "train_report.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/gap_bounds_fit.hpp"

namespace limber {

namespace {

constexpr std::size_t kFewLevels = 5;  // transitions have 3

/// Values that the set points of the most varied channel take, kFewLevels + 1 at most; 0 without
/// set points.
std::size_t most_levels(const std::vector<Episode>& episodes) {
  std::size_t most = 0;
  const Eigen::Index channels = episodes.empty() ? 0 : episodes.front().setpoint_kpa.cols();
  for (Eigen::Index channel = 0; channel < channels; ++channel) {
    std::set<float> levels;
    for (const Episode& episode : episodes) {
      for (Eigen::Index t = 0; t < episode.setpoint_kpa.rows() && levels.size() <= kFewLevels;
           ++t) {
        levels.insert(episode.setpoint_kpa(t, channel));
      }
    }
    most = std::max(most, levels.size());
  }
  return most;
}

/// Of recordings between whose set points nothing was recorded.
void warn_of_few_levels(const CommonFlags& flags, const std::vector<Episode>& episodes) {
  const std::size_t levels = most_levels(episodes);
  if (levels > 1 && levels <= kFewLevels) {
    warn(flags,
         "no segment's set points take more than {} values. Between them nothing was "
         "recorded, and the error there is many times that of these: record random motions too "
         "(limber collect --schedule random)",
         levels);
  }
}

/// The episodes of all recordings; `sources` names the files and their hashes.
std::vector<Episode> episodes_of(const BoundModelRequest& request, const ArmDescription& arm,
                                 std::string& sources) {
  std::vector<Episode> episodes;
  for (const std::vector<std::string>* paths : {&request.data, &request.old_data}) {
    for (const std::string& path : *paths) {
      Recording recording = read_recording_of(arm, path);
      std::move(recording.episodes.begin(), recording.episodes.end(), std::back_inserter(episodes));
      add_source(sources, path, file_hash(path));
    }
  }
  return episodes;
}

const char* status_of(const TrainingResult& result) {
  return result.status == TrainingStatus::finished      ? "finished"
         : result.status == TrainingStatus::interrupted ? "interrupted"
                                                        : "diverged";
}

/// How large the model's error is on motions that it has not seen, or why that is not known.
std::string error_line(const CompensationModel& model, bool has_unseen) {
  if (model.prediction_error) {
    return to_text(*model.prediction_error) + (model.tube ? "\n" + to_text(*model.tube) : "");
  }
  return has_unseen ? "the model's error could not be measured: its predictions diverge, or the "
                      "arm was not tracked often enough"
                    : "no motions were left to measure the "
                      "model's error on; give --unseen RECORDING";
}

/// Which epoch was chosen, and why.
std::string chosen_epoch(const TrainingResult& result) {
  return std::isnan(result.best_validation_position_error_cm)
             ? fmt::format("best by training loss (nothing was held back): epoch {}",
                           result.best_epoch)
             : fmt::format("best by validation: epoch {}, open-loop tip error {:.2f} cm{}",
                           result.best_epoch, result.best_validation_position_error_cm,
                           result.model.member_count() > 1 ? ", mean of the networks" : "");
}

Json json_of(const CommonFlags& flags, const Command& command, const TrainingFiles& files,
             const TrainingResult& result, const EpisodeChoice& choice) {
  const LearningCurvePoint& last = result.curve.back();
  Json json;
  json["status"] = status_of(result);
  json["model"] = files.model;
  json["learning_curve"] = files.learning_curve.string();
  json["preset"] = result.model.preset;
  json["shape"] = result.model.shape();
  json["seed"] = flags.seed;
  json["epochs"] = last.epoch;
  json["best_epoch"] = result.best_epoch;
  json["passed_over_epochs"] = result.passed_over_epochs;
  json["loss"] = last.loss;
  json["validation_position_error_cm"] = result.best_validation_position_error_cm;
  json["validation_episodes"] = choice.validation;
  json["broken_episodes"] = choice.broken;
  json["members"] = result.model.member_count();
  json["learnt_from"] = commands_are(result.model.learnt_from_setpoints);
  json["valves"] = to_json(result.model.identified_valves());
  if (result.model.member_count() > 1) {
    json["member_validation_position_error_cm"] = result.member_validation_position_error_cm;
  }
  json["prediction_error"] =
      result.model.prediction_error ? to_json(*result.model.prediction_error) : Json();
  json["tube"] = result.model.tube ? to_json(*result.model.tube) : Json();
  if (result.model.learnt) {
    json["learnt"] = to_json(*result.model.learnt, command);
  }
  if (result.model.bounds) {
    json["bounds"] = to_json(*result.model.bounds);
  }
  json["long_rollout"] = result.long_rollout.frames > 0 ? to_json(result.long_rollout) : Json();
  return json;
}

/// What the check of long rollouts made of the best epochs.
void say_what_ran_away(const CommonFlags& flags, const TrainingResult& result) {
  if (!result.passed_over_epochs.empty()) {
    say(flags,
        "passed over epoch {}: in a rollout of {} frames its networks ran away, so that bounds had "
        "to hold them; epoch {} is the next best",
        fmt::join(result.passed_over_epochs, ", "), kLongRolloutFrames, result.best_epoch);
  }
  if (const auto seeds = result.model.training.find("passed_over_seeds");
      seeds != result.model.training.end()) {
    say(flags,
        "a network of seed {} ran away in a rollout of {} frames; this one is of another, {}",
        seeds->second, kLongRolloutFrames, result.model.training.at("seed"));
  }
  if (result.long_rollout.frames > 0 && !result.long_rollout.bounded) {
    warn(flags,
         "the networks of all epochs kept run away in a rollout of {} frames (of epoch {}, "
         "bounds hold {:.0f} % of them); more recordings or another --seed may help",
         kLongRolloutFrames, result.best_epoch, 100.0 * result.long_rollout.held_share);
  }
}

/// noise_multiplied() on what chose the epoch, with a warning; null of a family, which is no arm's.
Json noise_of(const CommonFlags& flags, const ArmDescription& arm, const CompensationModel& model,
              const TrainingData& data) {
  if (model.family) {
    return nullptr;
  }
  const double times =
      noise_multiplied(ForwardModel(arm, model),
                       data.validation.empty() ? data.training : data.validation, flags.jobs);
  if (const std::string warning = noise_warning(times); !warning.empty()) {
    warn(flags, "the noise of a tracker comes out of one step {:.1f} times as large: {}", times,
         warning);
  }
  return times;
}

}  // namespace

int add_bounds_to_model(const BoundModelRequest& request, const CommonFlags& flags) {
  refuse_if(
      request.from.empty(),
      "--epochs 0 trains nothing: it only adds bounds to an old model, and needs --from MODEL");
  refuse_to_overwrite(request.out, flags.force);
  const ArmDescription arm = load_any_arm(request.arm);
  CompensationModel model = read_model(request.from);
  require_model_of(model, arm, request.from);
  if (model.arm_description.empty()) {
    model.set_arm(arm);
  }
  std::string sources;
  const std::vector<Episode> episodes = episodes_of(request, arm, sources);
  const GapBounds recorded = gap_bounds_of(episodes);
  model.bounds = model.bounds ? joined(*model.bounds, recorded) : recorded;
  model.training["bounds"] = sources;
  const LongRollout rollout = roll_out_long(ForwardModel(arm, model), episodes);
  write_model(request.out, model);
  if (!rollout.bounded) {
    warn(flags,
         "in {:.0f} % of a rollout of {} frames a bound held a gap: this network runs away "
         "without them. Train it again, which picks another epoch",
         100.0 * rollout.held_share, rollout.frames);
  }
  print_result(
      flags,
      {{"status", "bounded"},
       {"model", request.out},
       {"from", request.from},
       {"bounds", to_json(*model.bounds)},
       {"long_rollout", to_json(rollout)},
       {"warnings", flags.warnings}},
      fmt::format("{}: {} as it was, and {}", request.out, request.from, to_text(*model.bounds)));
  return kExitDone;
}

void say_broken(const CommonFlags& flags, const EpisodeChoice& choice) {
  for (const std::string& broken : choice.broken) {
    warn(flags, "left out as broken: {}; --keep-broken learns from it too", broken);
  }
}

void say_little(const CommonFlags& flags, const ArmDescription& arm,
                const std::vector<Episode>& episodes) {
  double moving_s = 0.0, all_s = 0.0;
  for (const Episode& episode : episodes) {
    const double seconds = episode.frame_count() * arm.frame_period_s();
    all_s += seconds;
    moving_s += moves(arm, episode) ? seconds : 0.0;
  }
  say(flags,
      "{:.1f} minutes, {:.1f} of them in episodes that move: too little to hold anything back. "
      "Networks that each lack one of {} parts of these say in which way to learn and how large "
      "the error is; then one learns from everything (--validation or --epochs: as with more data)",
      all_s / 60.0, moving_s / 60.0, kFolds);
  warn_of_few_levels(flags, episodes);
}

void say_episodes(const CommonFlags& flags, const EpisodeChoice& choice) {
  say_broken(flags, choice);
  warn_of_few_levels(flags, choice.data.training);
  if (choice.validation.empty()) {
    say(flags, "nothing is held back to validate on: there is too little");
  } else {
    say(flags, "validating on {}", fmt::join(choice.validation, "; "));
  }
}

void say_training(const CommonFlags& flags, const TrainingData& data,
                  const TrainingSettings& settings) {
  say(flags, "training {} on {} episodes, validating on {}; preset {}, {} epochs, seed {}",
      settings.ensemble > 1 ? fmt::format("{} networks", settings.ensemble) : "a network",
      data.training.size() + data.slices.frame_counts.size(), data.validation.size(),
      settings.preset, settings.epoch_count(), settings.seed);
}

void print_no_model(const CommonFlags& flags, const TrainingResult& result) {
  const std::string why = "no epoch was validated before training ended; no model was written";
  const bool interrupted = result.status == TrainingStatus::interrupted;
  print_error(why);
  print_result(flags,
               {{"status", interrupted ? "interrupted" : "diverged"},
                {"message", interrupted ? why : result.message},
                {"warnings", flags.warnings}},
               "");
}

void print_training_result(const CommonFlags& flags, const ArmDescription& arm,
                           const TrainingFiles& files, const TrainingResult& result,
                           const std::optional<FineTuningReport>& changes,
                           const EpisodeChoice& choice,
                           const std::optional<CrossValidation>& folds) {
  say_what_ran_away(flags, result);
  Json json = json_of(flags, arm.command, files, result, choice);
  json["noise_multiplied"] = noise_of(flags, arm, result.model, choice.data);
  json["cross_validation"] = folds ? to_json(*folds) : Json();
  if (changes) {
    json["fine_tuning"] = to_json(*changes);
  }
  json["warnings"] = flags.warnings;
  json["wall_time_s"] = result.wall_time_s;
  print_result(
      flags, json,
      fmt::format("{}: {}{} ({}), {} epochs in {:.1f} s, {}; {}\n{}{}", files.model,
                  result.model.member_count() > 1
                      ? fmt::format("{} networks ", result.model.member_count())
                      : "",
                  result.model.shape(), result.model.preset, result.curve.back().epoch,
                  result.wall_time_s, status_of(result),
                  folds ? fmt::format("epoch {}, by cross-validation", result.best_epoch)
                        : chosen_epoch(result),
                  folds && !result.model.prediction_error
                      ? "the folds' error is not known, or not this network's, whose training "
                        "did not end: plans keep what is usual"
                      : error_line(result.model, !choice.data.unseen.empty()),
                  changes ? "\n" + to_text(*changes) : ""));
}

}  // namespace limber
