#include "training_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checkpoint.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/units.hpp"
#include "limber/training/arm_fit.hpp"
#include "limber/training/episode_slices.hpp"
#include "rollout.hpp"
#include "run_identity.hpp"

namespace limber {

namespace {

constexpr int kRivals = 10;  // epochs that are kept to choose from

TrainingSettings usable(TrainingSettings settings, const CompensationModel* start, bool validates) {
  require_usable(settings);
  refuse_if(settings.keep_epoch > 0 && validates,
            "keep_epoch says which epoch is kept, and so would validation; give one of them");
  refuse_if(
      start != nullptr && settings.family_size > 0,
      "training setting family_size = {}; expected 0: a family is trained from the start, and "
      "what is fine-tuned stays one arm's",
      settings.family_size);
  return start != nullptr ? in_form_of(*start, std::move(settings)) : settings;
}

/// Whether there is a frame to measure the validation error by.
bool tells_an_error(const std::vector<Episode>& validation, const TrainingSettings& settings) {
  return settings.family_size > 0
             ? tells_of_other_arms(validation)
             : measured_frames(validation, pieces_of_length(validation, kValidationFrames)) > 0;
}

}  // namespace

TrainingRun::TrainingRun(const ArmDescription& arm, const TrainingData& data,
                         TrainingSettings settings, const CompensationModel* start,
                         const TrainingHooks& hooks)
    : arm_(arm),
      data_(data),
      settings_(usable(std::move(settings), start, !data.validation.empty())),
      hooks_(hooks),
      trainer_(arm, data, settings_, start),
      begin_(std::chrono::steady_clock::now()) {
  if (!data.validation.empty() && !tells_an_error(data.validation, settings_)) {
    throw InputError(
        settings_.family_size > 0
            ? "every arm held back for validation was recorded too briefly, or tracked too rarely, "
              "to be fitted and judged; give longer recordings"
            : "the validation data hold no tracked frame behind another: no error can be measured; "
              "give others with --validation, or look at them with limber inspect");
  }
}

double TrainingRun::elapsed_s() const {
  return elapsed_before_s_ + seconds_since(begin_);
}

void TrainingRun::validate(LearningCurvePoint& point) {
  TrainingState& state = trainer_.state();
  const Eigen::VectorXf& weights = state.parameters;
  double error_m = point.loss;  // without validation data the training loss decides
  std::vector<double> members_m;
  if (!data_.validation.empty() && settings_.family_size > 0) {
    error_m = error_on_other_arms_m(arm_, trainer_.model_of_member(weights, 0), data_.validation,
                                    settings_.jobs);
    members_m.push_back(error_m);
    point.validation_position_error_cm = kCmPerM * error_m;
  } else if (!data_.validation.empty()) {
    const std::vector<RolloutPiece> pieces = pieces_of_length(data_.validation, kValidationFrames);
    std::vector<std::vector<FrameMatrix>> predicted;
    for (int member = 0; member < trainer_.member_count(); ++member) {
      const ForwardModel model(arm_, trainer_.model_of_member(weights, member));
      predicted.push_back(roll_out(model, data_.validation, pieces, settings_.jobs));
      members_m.push_back(mean_tip_error_m(predicted.back(), data_.validation, pieces));
    }
    error_m = mean_tip_error_m(mean_of(predicted, arm_.dimension), data_.validation, pieces);
    point.validation_position_error_cm = kCmPerM * error_m;
  }
  if (!std::isfinite(error_m)) {
    return;
  }
  const auto tenth = [&](int epoch) { return (epoch - 1) * kRivals / settings_.epoch_count(); };
  if (settings_.keep_epoch > 0) {
    error_m = settings_.keep_epoch - point.epoch;  // the one asked for, or those before it
  }
  if (state.rivals.empty() || tenth(state.rivals.back().epoch) != tenth(point.epoch)) {
    state.rivals.push_back({point.epoch, error_m, members_m, weights});
  } else if (error_m < state.rivals.back().error_m) {
    state.rivals.back() = {point.epoch, error_m, members_m, weights};
  }
}

double TrainingRun::seconds_per_epoch(const TrainingStage& stage) {
  constexpr double kTrial_s = 0.3;
  const double load_begin = elapsed_s();
  trainer_.load(trainer_.slice_count() - 1);
  trainer_.load(0);
  const double load_s = 0.5 * (elapsed_s() - load_begin);
  const std::vector<int> starts = trainer_.shuffled_starts(stage);
  const std::size_t batch = std::min(std::size_t(stage.windows_per_batch), starts.size());
  const std::span<const int> first_batch = std::span(starts).first(batch);
  const TrainingState before = trainer_.state();
  trainer_.rehearse(stage, first_batch);  // the first touches every page
  const double begin = elapsed_s();
  int batches = 0;
  do {
    trainer_.rehearse(stage, first_batch);
    ++batches;
  } while (elapsed_s() - begin < kTrial_s);
  const double seconds = (elapsed_s() - begin) / batches;
  LearningCurvePoint unused;
  const double validation_begin = elapsed_s();
  validate(unused);
  const double validation_s =
      (elapsed_s() - validation_begin) / std::min(settings_.validation_interval, stage.epochs);
  trainer_.state() = before;
  return trainer_.slice_count() * (load_s + seconds * double(starts.size()) / double(batch)) +
         validation_s;
}

void TrainingRun::fit_epochs_to_time_limit() {
  constexpr double kMargin = 0.95;
  const auto seconds = sum_of<double>(settings_.stages, [&](const TrainingStage& stage) {
    return stage.epochs * seconds_per_epoch(stage);
  });
  const double left = kMargin * settings_.time_limit_s - elapsed_s();
  constexpr double kMaxEpochsInTime = 1e6;
  const int epochs =
      int(std::clamp(settings_.epoch_count() * left / seconds, 0.0, kMaxEpochsInTime));
  set_epoch_count(settings_, std::max(epochs, int(settings_.stages.size())));
}

std::string TrainingRun::divergence_message(int epoch, const EpochLoss& loss) const {
  const auto member = std::size_t(loss.diverged);
  return fmt::format(
      "training diverged in epoch {} at learning rate {:.3g}{}: loss {:.4g}, {:.4g} at the start "
      "of this stage. Try --learning-rate {:.1g}",
      epoch, trainer_.learning_rate(epoch - 1),
      trainer_.member_count() > 1 ? fmt::format(", network {} of the ensemble", member) : "",
      loss.diverged_loss, trainer_.state().stage_first_loss[member],
      settings_.learning_rate / 10.0);
}

LongRollout TrainingRun::roll_out_long_each(const Eigen::VectorXf& weights) const {
  const std::vector<Episode> episodes =
      data_.validation.empty() ? training_sample(data_) : data_.validation;
  LongRollout worst;
  for (int member = 0; member < trainer_.member_count(); ++member) {
    const ForwardModel model(arm_, trainer_.model_of_member(weights, member));
    const LongRollout one = roll_out_long(model, episodes);
    if (member == 0 ||
        std::pair(!one.bounded, one.held_share) > std::pair(!worst.bounded, worst.held_share)) {
      worst = one;
    }
  }
  return worst;
}

TrainingResult TrainingRun::chosen_result() const {
  auto order = mapped<const ValidatedEpoch*>(trainer_.state().rivals,
                                             [&](const ValidatedEpoch& rival) { return &rival; });
  std::ranges::stable_sort(order, {}, [](const ValidatedEpoch* rival) { return rival->error_m; });
  const ValidatedEpoch* choice = order.front();
  std::vector<int> passed_over;
  LongRollout kept;  // of the best one where none is bounded
  for (const ValidatedEpoch* rival : order) {
    const LongRollout rollout = roll_out_long_each(rival->weights);
    if (rollout.bounded || passed_over.empty()) {
      kept = rollout;
    }
    if (rollout.bounded) {
      choice = rival;
      break;
    }
    passed_over.push_back(rival->epoch);
  }
  TrainingResult chosen = result(TrainingStatus::finished, "", choice);
  chosen.long_rollout = kept;
  if (kept.bounded && !passed_over.empty()) {
    chosen.model.training["passed_over_epochs"] = fmt::format("{}", fmt::join(passed_over, " "));
    chosen.passed_over_epochs = std::move(passed_over);
  }
  return chosen;
}

TrainingResult TrainingRun::result(TrainingStatus status, std::string message) const {
  return result(status, std::move(message), trainer_.state().best());
}

TrainingResult TrainingRun::result(TrainingStatus status, std::string message,
                                   const ValidatedEpoch* choice) const {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const TrainingState& state = trainer_.state();
  TrainingResult result;
  result.status = status;
  result.message = std::move(message);
  result.curve = state.curve;
  result.wall_time_s = elapsed_s();
  result.best_validation_position_error_cm = kUnknown;
  if (choice == nullptr) {
    return result;
  }
  result.best_epoch = choice->epoch;
  std::vector<int> order(std::size_t(trainer_.member_count()));
  std::iota(order.begin(), order.end(), 0);
  if (!data_.validation.empty()) {
    result.best_validation_position_error_cm = kCmPerM * choice->error_m;
    std::ranges::stable_sort(order, {}, [&](int member) { return choice->members_m[member]; });
    for (const int member : order) {
      result.member_validation_position_error_cm.push_back(kCmPerM * choice->members_m[member]);
    }
  }
  result.model = trainer_.model_of(choice->weights, order);
  auto& record = result.model.training;
  record["epochs"] = std::to_string(settings_.epoch_count());
  record["epochs_done"] = std::to_string(state.epochs_done);
  record["best_epoch"] = std::to_string(choice->epoch);
  record["seed"] = std::to_string(settings_.seed);
  record["learning_rate"] = fmt::format("{}", settings_.learning_rate);
  record["final_loss"] = fmt::format("{:.6g}", state.curve.back().loss);
  record["training_frames"] = std::to_string(trainer_.frame_count());
  if (!data_.validation.empty()) {
    record["validation_position_error_cm"] =
        fmt::format("{:.4g}", result.best_validation_position_error_cm);
  }
  if (trainer_.member_count() > 1) {
    record["ensemble"] = std::to_string(trainer_.member_count());
    record["member_validation_position_error_cm"] =
        fmt::format("{:.4g}", fmt::join(result.member_validation_position_error_cm, " "));
  }
  return result;
}

void TrainingRun::resume() {
  const TrainingState& fresh = trainer_.state();
  Checkpoint checkpoint = read_checkpoint(
      settings_.checkpoint, identity_,
      {fresh.parameters.size(), trainer_.member_count(), fresh.optimiser.first_moment.size() > 0,
       fresh.optimiser.rotations.size(), !data_.validation.empty()});
  require_same_stages(settings_, checkpoint.stages);
  settings_.stages = std::move(checkpoint.stages);
  settings_.time_limit_s = 0.0;
  trainer_.state() = std::move(checkpoint.state);
  elapsed_before_s_ = checkpoint.elapsed_s;
}

void TrainingRun::store(bool now) {
  if (!settings_.checkpoint.empty() &&
      (now || elapsed_s() - stored_s_ >= settings_.checkpoint_interval_s)) {
    write_checkpoint(settings_.checkpoint,
                     {identity_, settings_.stages, elapsed_s(), trainer_.state()});
    stored_s_ = elapsed_s();
  }
}

std::string TrainingRun::progress_note(const LearningCurvePoint& point) const {
  std::string note = fmt::format("window {}, loss {:.3f}", point.window_frames, point.loss);
  if (const ValidatedEpoch* best = trainer_.state().best(); best && !data_.validation.empty()) {
    note += fmt::format(", best validation {:.2f} cm", kCmPerM * best->error_m);
  }
  return note;
}

int TrainingRun::end() const {
  return settings_.keep_epoch > 0 ? settings_.keep_epoch : settings_.epoch_count();
}

bool TrainingRun::is_validated(int epoch) const {
  return epoch % settings_.validation_interval == 0 || epoch == settings_.epoch_count() ||
         epoch == settings_.keep_epoch;
}

void TrainingRun::finish_epoch(Progress& progress) {
  LearningCurvePoint point = trainer_.state().curve.back();
  if (is_validated(point.epoch)) {
    validate(point);
  }
  point.elapsed_s = elapsed_s();
  trainer_.state().curve.back() = point;
  progress.update(std::uint64_t(point.epoch), progress_note(point));
  store(false);
  if (hooks_.on_epoch) {
    hooks_.on_epoch(point);
  }
}

std::optional<TrainingResult> TrainingRun::run_stage(const TrainingStage& stage, int stage_end,
                                                     Progress& progress) {
  TrainingState& state = trainer_.state();
  const int last_epoch = std::min(stage_end, end());
  const int stop_epoch = settings_.stop_after_epochs > 0 ? settings_.stop_after_epochs : -1;
  while (state.epochs_done < last_epoch) {
    const bool is_stopped = interrupt_requested() || (hooks_.should_stop && hooks_.should_stop());
    if (is_stopped || state.epochs_done == stop_epoch) {
      store(true);
      return result(TrainingStatus::interrupted, "stopped by the user");
    }
    LearningCurvePoint point;
    point.epoch = state.epochs_done + 1;
    point.window_frames = stage.window_frames;
    point.learning_rate = trainer_.learning_rate(state.epochs_done);
    const EpochLoss loss = trainer_.train_epoch(stage, hooks_.should_stop);
    if (loss.stopped) {
      return result(TrainingStatus::interrupted, "stopped by the user");
    }
    if (loss.diverged >= 0) {
      return result(TrainingStatus::diverged, divergence_message(point.epoch, loss));
    }
    ++state.epochs_done;
    if (state.epochs_done == stage_end) {
      trainer_.end_stage();
    }
    point.loss = loss.mean;
    point.validation_position_error_cm = std::numeric_limits<double>::quiet_NaN();
    point.elapsed_s = elapsed_s();
    state.curve.push_back(point);
    finish_epoch(progress);
  }
  return std::nullopt;
}

TrainingResult TrainingRun::run() {
  if (!settings_.checkpoint.empty()) {
    identity_ = run_identity(arm_, data_, settings_, trainer_);
    if (settings_.resume) {
      resume();
    }
  }
  if (settings_.time_limit_s > 0.0) {
    try {
      fit_epochs_to_time_limit();
    } catch (const Interrupted&) {  // nothing is learnt yet
      return result(TrainingStatus::interrupted, "stopped by the user");
    }
  }
  try {
    return run_stages();
  } catch (const Interrupted&) {  // of a validation or the last rollouts, between two epochs
    store(true);
    return result(TrainingStatus::interrupted, "stopped by the user");
  }
}

TrainingResult TrainingRun::run_stages() {
  Progress progress("train", "epochs", std::uint64_t(end()), settings_.progress);
  const std::vector<LearningCurvePoint>& curve = trainer_.state().curve;
  if (!data_.validation.empty() && !curve.empty() && is_validated(curve.back().epoch) &&
      std::isnan(curve.back().validation_position_error_cm)) {
    finish_epoch(progress);  // the run that this one resumes was stopped within its validation
  }
  int stage_end = 0;
  for (const TrainingStage& stage : settings_.stages) {
    stage_end += stage.epochs;
    if (trainer_.state().epochs_done >= std::min(stage_end, end())) {
      continue;
    }
    if (std::optional<TrainingResult> ended = run_stage(stage, stage_end, progress)) {
      return std::move(*ended);
    }
  }
  progress.finish();
  if (trainer_.state().best() == nullptr) {
    // Not stored: resuming it would end here again.
    return result(
        TrainingStatus::diverged,
        "the validation error was finite in no epoch, so there is no best epoch to keep; try a "
        "smaller --learning-rate, or look at the data with limber inspect");
  }
  store(true);
  return chosen_result();
}

}  // namespace limber
