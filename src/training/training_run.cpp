#include "training_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checkpoint.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/units.hpp"
#include "limber/training/rollout.hpp"

namespace limber {

namespace {

constexpr int kValidationFrames = 600;
// A batch whose loss is this many times the stage's first has left every sensible region.
constexpr double kExplosion = 100.0;
// An epoch that ends this many times worse than its stage began isn't learning but wandering off.
constexpr double kWorsening = 3.0;
// Streams of one seed: the shuffles of epochs, and the noise of batches, far apart from each other.
constexpr std::uint64_t kShuffleStreams = 1ULL << 32;
constexpr std::uint64_t kNoiseStreams = 1ULL << 33;

std::vector<int> widths(const TrainingTables& tables, const std::vector<int>& hidden) {
  std::vector<int> result = {static_cast<int>(tables.input.scale.size())};
  result.insert(result.end(), hidden.begin(), hidden.end());
  result.push_back(static_cast<int>(tables.output.scale.size()));
  return result;
}

TrainingTables tables_for(const ArmDescription& arm, const TrainingData& data,
                          const TrainingSettings& settings, const CompensationModel* start) {
  require_usable(settings);
  if (start != nullptr) {
    return make_training_tables(arm, data.training, settings, start->input, start->output);
  }
  return make_training_tables(arm, data.training, settings);
}

/// The settings with the layout and hidden units of `start`.
TrainingSettings in_form_of(const CompensationModel& start, TrainingSettings settings) {
  settings.layout = start.layout;
  settings.hidden_units.clear();
  for (std::size_t layer = 0; layer + 1 < start.layers.size(); ++layer) {
    settings.hidden_units.push_back(static_cast<int>(start.layers[layer].bias.size()));
  }
  return settings;
}

}  // namespace

TrainingRun::TrainingRun(const ArmDescription& arm, const TrainingData& data,
                         TrainingSettings settings, const CompensationModel* start)
    : arm_(arm),
      data_(data),
      settings_(start != nullptr ? in_form_of(*start, std::move(settings)) : std::move(settings)),
      tables_(tables_for(arm, data, settings_, start)),
      layout_({1, 1}),
      begin_(std::chrono::steady_clock::now()) {
  layout_ = ParameterLayout(widths(tables_, settings_.hidden_units));
  for (const TrainingStage& stage : settings_.stages) {
    if (window_starts(tables_.episodes, stage.window_frames, 0).empty()) {
      throw InputError(fmt::format(
          "the longest training episode has {} frames; preset '{}' needs windows of {} frames and "
          "the one before them",
          std::ranges::max(tables_.episodes, {}, &EpisodeRange::count).count, settings_.preset,
          stage.window_frames));
    }
  }
  state_.parameters = start != nullptr ? to_parameters(layout_, start->layers)
                                       : initial_parameters(layout_, settings_.seed);
  state_.optimiser = OptimiserState(settings_.optimiser, layout_.size());
  if (settings_.average_decay > 0.0) {
    state_.average = state_.parameters;
  }
  gradient_.setZero(layout_.size());
}

double TrainingRun::elapsed_s() const {
  return elapsed_before_s_ +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

double TrainingRun::learning_rate(double epochs) const {
  return settings_.cosine_decay
             ? cosine_decayed(settings_.learning_rate, epochs / settings_.epoch_count())
             : settings_.learning_rate;
}

std::vector<int> TrainingRun::shuffled_starts(const TrainingStage& stage) const {
  RandomStream random(settings_.seed,
                      kShuffleStreams + static_cast<std::uint64_t>(state_.epochs_done));
  const auto frames = static_cast<std::uint32_t>(stage.window_frames);
  const int shift = settings_.shift_windows ? static_cast<int>(random.index(frames)) : 0;
  std::vector<int> starts = window_starts(tables_.episodes, stage.window_frames, shift);
  for (std::size_t i = starts.size(); i > 1; --i) {
    std::swap(starts[i - 1], starts[random.index(static_cast<std::uint32_t>(i))]);
  }
  return starts;
}

void TrainingRun::step(double loss_scale, double rate) {
  if (loss_scale != 1.0) {
    gradient_ *= static_cast<float>(loss_scale);
  }
  limit_norm(gradient_, settings_.gradient_norm_limit);
  optimiser_step(settings_.optimiser, gradient_, rate, state_.optimiser, state_.parameters);
  if (settings_.average_decay > 0.0) {
    // Short at first, so that the average forgets the random start.
    const auto step = static_cast<double>(state_.optimiser.step);
    const double decay = std::min(settings_.average_decay, (1.0 + step) / (10.0 + step));
    state_.average += static_cast<float>(1.0 - decay) * (state_.parameters - state_.average);
  }
}

TrainingRun::EpochLoss TrainingRun::train_epoch(const TrainingStage& stage,
                                                BatchGradient& gradient) {
  const std::vector<int> starts = shuffled_starts(stage);
  const auto batch = static_cast<std::size_t>(stage.windows_per_batch);
  double sum = 0.0;
  for (std::size_t first = 0; first < starts.size(); first += batch) {
    const std::size_t count = std::min(batch, starts.size() - first);
    const auto step_number = static_cast<std::uint64_t>(state_.optimiser.step);
    const double loss = gradient.compute(
        std::span(starts).subspan(first, count), state_.parameters, settings_.input_noise,
        settings_.seed,
        kNoiseStreams + step_number * static_cast<std::uint64_t>(gradient.chunk_count()),
        gradient_);
    const double mean = loss / static_cast<double>(count);
    state_.stage_first_loss = state_.stage_first_loss > 0.0 ? state_.stage_first_loss : mean;
    if (!std::isfinite(mean) || mean > kExplosion * state_.stage_first_loss) {
      return {mean, true};
    }
    sum += loss;
    const double progress = static_cast<double>(first) / static_cast<double>(starts.size());
    const bool summed = settings_.reduction == LossReduction::sum_over_batch;
    step(summed ? 1.0 : 1.0 / static_cast<double>(count),
         learning_rate(state_.epochs_done + progress));
  }
  const double mean = sum / static_cast<double>(starts.size());
  return {mean, mean > kWorsening * state_.stage_first_loss};
}

CompensationModel TrainingRun::model_of(const Eigen::VectorXf& parameters) const {
  CompensationModel model;
  model.layout = settings_.layout;
  model.layers = to_layers(layout_, parameters);
  model.input = tables_.input;
  model.output = tables_.output;
  model.arm_name = arm_.name;
  model.arm_hash = arm_.hash();
  model.segment_count = arm_.segment_count();
  model.point_count = arm_.point_count();
  model.preset = settings_.preset;
  return model;
}

void TrainingRun::validate(LearningCurvePoint& point) {
  const Eigen::VectorXf& weights =
      settings_.average_decay > 0.0 ? state_.average : state_.parameters;
  double error_m = point.loss;  // without validation data the training loss decides
  if (!data_.validation.empty()) {
    const ForwardModel model(arm_, model_of(weights));
    const std::vector<RolloutPiece> pieces = pieces_of_length(data_.validation, kValidationFrames);
    error_m = mean_tip_error_m(roll_out(model, data_.validation, pieces, settings_.jobs),
                               data_.validation, pieces);
    point.validation_position_error_cm = kCmPerM * error_m;
  }
  if (std::isfinite(error_m) && (state_.best_epoch == 0 || error_m < state_.best_error_m)) {
    state_.best = weights;
    state_.best_error_m = error_m;
    state_.best_epoch = point.epoch;
  }
}

double TrainingRun::seconds_per_epoch(const TrainingStage& stage) {
  constexpr double kTrial_s = 0.3;
  const std::vector<int> starts = shuffled_starts(stage);
  const std::size_t batch =
      std::min(static_cast<std::size_t>(stage.windows_per_batch), starts.size());
  BatchGradient gradient(tables_, layout_, stage.window_frames, stage.windows_per_batch,
                         settings_.jobs);
  const TrainingState before = state_;
  const auto compute = [&] {
    gradient.compute(std::span(starts).first(batch), state_.parameters, 0.0, 0, 0, gradient_);
    step(0.0, 0.0);
  };
  compute();  // the first touches every page
  const double begin = elapsed_s();
  int batches = 0;
  do {
    compute();
    ++batches;
  } while (elapsed_s() - begin < kTrial_s);
  const double seconds = (elapsed_s() - begin) / batches;
  LearningCurvePoint unused;
  const double validation_begin = elapsed_s();
  validate(unused);
  const double validation_s =
      (elapsed_s() - validation_begin) / std::min(settings_.validation_interval, stage.epochs);
  state_ = before;
  return seconds * static_cast<double>(starts.size()) / static_cast<double>(batch) + validation_s;
}

void TrainingRun::fit_epochs_to_time_limit() {
  constexpr double kMargin = 0.95;
  double seconds = 0.0;
  for (const TrainingStage& stage : settings_.stages) {
    seconds += stage.epochs * seconds_per_epoch(stage);
  }
  const double left = kMargin * settings_.time_limit_s - elapsed_s();
  constexpr double kMostEpochs = 1e6;
  const int epochs =
      static_cast<int>(std::clamp(settings_.epoch_count() * left / seconds, 0.0, kMostEpochs));
  set_epoch_count(settings_, std::max(epochs, static_cast<int>(settings_.stages.size())));
}

std::string TrainingRun::divergence_message(int epoch, double loss) const {
  return fmt::format(
      "training diverged in epoch {} at learning rate {:.3g}: loss {:.4g}, {:.4g} at the start of "
      "this stage. Try --learning-rate {:.1g}",
      epoch, learning_rate(epoch - 1), loss, state_.stage_first_loss,
      settings_.learning_rate / 10.0);
}

TrainingResult TrainingRun::result(TrainingStatus status, std::string message) const {
  TrainingResult result;
  result.status = status;
  result.message = std::move(message);
  result.curve = state_.curve;
  result.best_epoch = state_.best_epoch;
  result.wall_time_s = elapsed_s();
  if (state_.best_epoch == 0) {
    return result;
  }
  result.best_validation_position_error_cm = data_.validation.empty()
                                                 ? std::numeric_limits<double>::quiet_NaN()
                                                 : kCmPerM * state_.best_error_m;
  result.model = model_of(state_.best);
  auto& record = result.model.training;
  record["epochs"] = std::to_string(settings_.epoch_count());
  record["epochs_done"] = std::to_string(state_.epochs_done);
  record["best_epoch"] = std::to_string(state_.best_epoch);
  record["seed"] = std::to_string(settings_.seed);
  record["learning_rate"] = fmt::format("{}", settings_.learning_rate);
  record["final_loss"] = fmt::format("{:.6g}", state_.curve.back().loss);
  record["validation_position_error_cm"] =
      fmt::format("{:.4g}", result.best_validation_position_error_cm);
  record["training_frames"] = std::to_string(tables_.frames.state.cols());
  return result;
}

std::string TrainingRun::identity() const {
  const auto bytes = [](const Eigen::MatrixXf& matrix) {
    return std::string_view(reinterpret_cast<const char*>(matrix.data()),
                            static_cast<std::size_t>(matrix.size()) * sizeof(float));
  };
  std::string text =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}", arm_.hash(), settings_.preset,
                  fmt::join(settings_.hidden_units, "-"), static_cast<int>(settings_.layout),
                  static_cast<int>(settings_.scaling), settings_.error_in_base_poses,
                  static_cast<int>(settings_.reduction), static_cast<int>(settings_.optimiser),
                  settings_.learning_rate, settings_.cosine_decay, settings_.gradient_norm_limit,
                  settings_.average_decay, settings_.input_noise, settings_.seed);
  text += content_hash(bytes(tables_.frames.pressure)) + content_hash(bytes(tables_.frames.state));
  for (const Episode& episode : data_.validation) {
    text += content_hash(bytes(episode.backbone));
  }
  return content_hash(text);
}

void TrainingRun::resume() {
  Checkpoint checkpoint = read_checkpoint(settings_.checkpoint, identity_);
  if (checkpoint.state.parameters.size() != layout_.size()) {
    throw InputError(fmt::format("{}: {} parameters; expected {}", settings_.checkpoint.string(),
                                 checkpoint.state.parameters.size(), layout_.size()));
  }
  settings_.stages = std::move(checkpoint.stages);
  settings_.time_limit_s = 0.0;
  state_ = std::move(checkpoint.state);
  elapsed_before_s_ = state_.curve.empty() ? 0.0 : state_.curve.back().elapsed_s;
}

void TrainingRun::store(bool now) {
  if (!settings_.checkpoint.empty() &&
      (now || elapsed_s() - stored_s_ > settings_.checkpoint_interval_s)) {
    write_checkpoint(settings_.checkpoint, {identity_, settings_.stages, state_});
    stored_s_ = elapsed_s();
  }
}

std::optional<TrainingResult> TrainingRun::run_stage(const TrainingStage& stage, int last_epoch,
                                                     Progress& progress) {
  BatchGradient gradient(tables_, layout_, stage.window_frames, stage.windows_per_batch,
                         settings_.jobs);
  const int stop_epoch = settings_.stop_after_epochs > 0 ? settings_.stop_after_epochs : -1;
  while (state_.epochs_done < last_epoch) {
    if (interrupt_requested() || state_.epochs_done == stop_epoch) {
      store(true);
      return result(TrainingStatus::interrupted, "stopped by the user");
    }
    LearningCurvePoint point;
    point.epoch = state_.epochs_done + 1;
    point.window_frames = stage.window_frames;
    point.learning_rate = learning_rate(state_.epochs_done);
    const EpochLoss loss = train_epoch(stage, gradient);
    if (loss.diverged) {
      return result(TrainingStatus::diverged, divergence_message(point.epoch, loss.mean));
    }
    ++state_.epochs_done;
    if (state_.epochs_done == last_epoch) {
      state_.stage_first_loss = 0.0;
    }
    point.loss = loss.mean;
    point.validation_position_error_cm = std::numeric_limits<double>::quiet_NaN();
    if (point.epoch % settings_.validation_interval == 0 ||
        point.epoch == settings_.epoch_count()) {
      validate(point);
    }
    point.elapsed_s = elapsed_s();
    state_.curve.push_back(point);
    progress.update(static_cast<std::uint64_t>(point.epoch),
                    fmt::format("window {}, loss {:.3f}, best validation {:.2f} cm",
                                point.window_frames, point.loss, kCmPerM * state_.best_error_m));
    store(false);
  }
  return std::nullopt;
}

TrainingResult TrainingRun::run() {
  if (!settings_.checkpoint.empty()) {
    identity_ = identity();
    if (settings_.resume) {
      resume();
    }
  }
  if (settings_.time_limit_s > 0.0) {
    fit_epochs_to_time_limit();
  }
  Progress progress("train", "epochs", static_cast<std::uint64_t>(settings_.epoch_count()),
                    settings_.progress);
  int last_epoch = 0;
  for (const TrainingStage& stage : settings_.stages) {
    last_epoch += stage.epochs;
    if (state_.epochs_done >= last_epoch) {
      continue;
    }
    if (std::optional<TrainingResult> ended = run_stage(stage, last_epoch, progress)) {
      return std::move(*ended);
    }
  }
  progress.finish();
  if (!settings_.checkpoint.empty()) {
    std::error_code ignored;  // a checkpoint that stays behind harms nobody
    std::filesystem::remove(settings_.checkpoint, ignored);
  }
  return result(TrainingStatus::finished, "");
}

}  // namespace limber
