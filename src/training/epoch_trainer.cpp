#include "epoch_trainer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "flushed_subnormals.hpp"
#include "learnt_kind.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/training/episode_slices.hpp"
#include "shuffle.hpp"

namespace limber {

namespace {

// A batch whose loss is this many times the stage's first has diverged.
constexpr double kExplosion = 100.0;
// An epoch that ends this many times worse than its stage began is not learning but drifting away.
constexpr double kWorsening = 3.0;
// Streams of one seed: the shuffles of epochs and the weights of the members behind the first, far
// apart from each other.
constexpr std::uint64_t kShuffleStreams = 1ULL << 32;
constexpr std::uint64_t kMemberStreams = 1ULL << 34;
constexpr std::uint64_t kSliceStep = 1ULL << 36;  // from one slice's shuffle to the next one's

ParameterLayout layout_for(const TrainingTables& tables, const TrainingSettings& settings,
                           const std::vector<int>& episode_arms) {
  ArmVectorTable arms;
  if (settings.family_size > 0) {
    arms = {settings.family_size, 1 + std::ranges::max(episode_arms)};
  }
  std::vector<int> widths = {int(tables.input.scale.size())};
  widths.insert(widths.end(), settings.hidden_units.begin(), settings.hidden_units.end());
  widths.push_back(tables.map.output_count());
  return ParameterLayout(std::move(widths), arms);
}

/// The arm of every episode of a family; empty where it is none.
std::vector<int> arms_of_episodes(const TrainingData& data, const TrainingSettings& settings) {
  if (settings.family_size == 0) {
    return {};
  }
  const std::size_t episodes = data.training.size() + data.slices.frame_counts.size();
  const bool fit = data.arms.empty() || data.arms.size() == episodes;
  if (!fit || !data.replay.empty() ||
      std::ranges::any_of(data.arms, [&](int arm) { return arm < 0 || arm >= int(episodes); })) {
    throw InputError(fmt::format(
        "{} arms for {} episodes of a family, and {} to replay; expected an arm from 0 to below "
        "the number of episodes for each of them, and none to replay",
        data.arms.size(), episodes, data.replay.size()));
  }
  std::vector<int> arms = data.arms;
  if (arms.empty()) {
    arms.resize(episodes);
    std::iota(arms.begin(), arms.end(), 0);
  }
  return arms;
}

TrainingTables tables_for(const ArmDescription& arm, const TrainingData& data,
                          const std::vector<int>& slice, const TrainingSettings& settings,
                          const CompensationModel* start) {
  std::vector<Episode> episodes = slice.empty() ? data.training : data.slices.read(slice);
  if (!slice.empty()) {
    require_episodes_of(episodes, arm, "training data");
  }
  episodes.insert(episodes.end(), data.replay.begin(), data.replay.end());
  TrainingTables like;
  if (start != nullptr) {
    like.input = start->input;
    like.output = start->output;
  }
  return make_training_tables(arm, episodes, settings, start != nullptr ? &like : nullptr);
}

}  // namespace

const ValidatedEpoch* TrainingState::best() const {
  const auto found = std::ranges::min_element(rivals, {}, &ValidatedEpoch::error_m);
  return found == rivals.end() ? nullptr : &*found;
}

EpochTrainer::EpochTrainer(const ArmDescription& arm, const TrainingData& data,
                           const TrainingSettings& settings, const CompensationModel* start)
    : arm_((require_data_of(data, arm), arm)),
      settings_(settings),
      members_(start != nullptr ? start->member_count() : settings.ensemble),
      sliced_(data.slices),
      episode_arms_(arms_of_episodes(data, settings)),
      loaded_(slices_of(sliced_, settings.seed, 0).front()),
      tables_(tables_for(arm, data, loaded_, settings, start)),
      layout_(layout_for(tables_, settings, episode_arms_)),
      optimiser_(make_optimiser(settings.optimiser, layout_, members_, settings.jobs)),
      replayed_(data.replay.size()) {
  slice_count_ = int(slices_of(sliced_, settings.seed, 0).size());
  if (!loaded_.empty() && frame_count() > sliced_.slice_frames) {
    spilled_.emplace(settings.checkpoint);
  }
  survey_ =
      survey_of(arm, data, settings.seed, start,
                [&](const std::vector<int>& slice, const std::vector<Episode>& episodes) {
                  if (spilled_) {
                    spilled_->add(make_training_tables(arm, episodes, settings, &tables_), slice);
                  }
                });
  note_arms(loaded_, tables_);
  set_bounds(tables_, settings_, survey_.bounds);
  for (const TrainingStage& stage : settings_.stages) {
    if (shuffled_starts(stage).empty()) {
      throw InputError(fmt::format(
          "the longest training episode has {} frames; preset '{}' needs windows of {} frames, in "
          "some of which the arm was tracked, and a tracked one before them",
          std::ranges::max(tables_.episodes, {}, &EpisodeRange::count).count, settings_.preset,
          stage.window_frames));
    }
  }
  state_.parameters.resize(layout_.size() * members_);
  for (int member = 0; member < members_; ++member) {
    auto own = state_.parameters.segment(member * layout_.size(), layout_.size());
    if (start != nullptr) {
      own = to_parameters(layout_, start->member(member).layers);
    } else {
      const std::uint64_t first_stream =
          member == 0 ? 0 : kMemberStreams + (std::uint64_t(member) << 16);
      Eigen::VectorXf initial =
          initial_parameters(layout_, settings_.seed, first_stream, settings_.first_weights);
      if (tables_.map.is_gated()) {
        set_gate_biases(layout_, tables_.map.output_count() / 2, kFirstGateBias, initial);
      }
      own = initial;
    }
  }
  state_.optimiser = optimiser_->first_state();
  gradient_.setZero(state_.parameters.size());
}

double EpochTrainer::learning_rate(double epochs) const {
  return settings_.cosine_decay
             ? cosine_decayed(settings_.learning_rate, epochs / settings_.epoch_count())
             : settings_.learning_rate;
}

void EpochTrainer::note_arms(const std::vector<int>& slice, TrainingTables& tables) const {
  for (std::size_t i = 0; i < tables.episodes.size() && !episode_arms_.empty(); ++i) {
    const std::size_t episode = slice.empty() ? i : std::size_t(slice[i]);
    tables.frames.arm.insert(tables.frames.arm.end(), std::size_t(tables.episodes[i].count),
                             episode_arms_[episode]);
  }
}

std::int64_t EpochTrainer::frame_count() const {
  const std::vector<int>& counts = sliced_.frame_counts;
  return counts.empty() ? tables_.frames.state.cols()
                        : std::reduce(counts.begin(), counts.end(), std::int64_t{0});
}

void EpochTrainer::load(int slice) {
  const std::vector<std::vector<int>> all = slices_of(sliced_, settings_.seed, state_.epochs_done);
  const auto at = std::size_t(slice);
  slice_ = slice;
  slice_count_ = int(all.size());
  if (all[at] != loaded_) {
    const bool is_next = next_.valid() && coming_ == all[at];
    if (!is_next) {
      next_ = {};
      tables_.frames = {};  // the old one's memory first
    }
    TrainingTables read = is_next ? next_.get() : spilled_->read(all[at]);
    tables_.frames = std::move(read.frames);
    tables_.episodes = std::move(read.episodes);
    note_arms(all[at], tables_);
    loaded_ = all[at];
  }
  if (at + 1 < all.size() && !(next_.valid() && coming_ == all[at + 1])) {
    coming_ = all[at + 1];
    next_ =
        std::async(std::launch::async, [this, slice = coming_] { return spilled_->read(slice); });
  }
}

std::vector<int> EpochTrainer::shuffled_starts(const TrainingStage& stage) const {
  RandomStream random(settings_.seed, kShuffleStreams + std::uint64_t(state_.epochs_done) +
                                          kSliceStep * std::uint64_t(slice_));
  const auto frames = std::uint32_t(stage.window_frames);
  const int shift = settings_.shift_windows ? int(random.index(frames)) : 0;
  const std::span all(tables_.episodes);
  const auto starts_in = [&](std::span<const EpisodeRange> episodes) {
    const auto shifted_by = [&](int by) {
      return window_starts(episodes, tables_.frames.tracked, stage.window_frames, by);
    };
    std::vector<int> shifted = shifted_by(shift);  // none if none is tracked
    return shifted.empty() && shift > 0 ? shifted_by(0) : shifted;
  };
  std::vector<int> starts = starts_in(all.first(all.size() - replayed_));
  if (replayed_ > 0) {
    std::vector<int> replayed = starts_in(all.last(replayed_));
    shuffle(random, replayed);
    const double share = settings_.replay_share / (1.0 - settings_.replay_share);
    const double wanted = share * double(starts.size());
    replayed.resize(std::min(replayed.size(), std::size_t(std::lround(wanted))));
    starts.insert(starts.end(), replayed.begin(), replayed.end());
  }
  shuffle(random, starts);
  return starts;
}

BatchGradient& EpochTrainer::gradient_for(const TrainingStage& stage) {
  if (batch_ == nullptr || gradient_stage_.window_frames != stage.window_frames ||
      gradient_stage_.windows_per_batch != stage.windows_per_batch) {
    batch_.reset();  // the old one's memory first
    batch_ = std::make_unique<BatchGradient>(tables_, layout_, stage.window_frames,
                                             stage.windows_per_batch, settings_.jobs, members_);
    gradient_stage_ = stage;
  }
  return *batch_;
}

void EpochTrainer::step(double loss_scale, double rate) {
  const FlushedSubnormals flushed;
  const auto scale = float(loss_scale);
  if (scale != 1.0F) {
    gradient_ *= scale;
  }
  for (int member = 0; member < members_; ++member) {
    limit_norm(gradient_.segment(member * layout_.size(), layout_.size()),
               settings_.gradient_norm_limit);
  }
  optimiser_->step(gradient_, rate, state_.optimiser, state_.parameters);
  if (settings_.weight_decay > 0.0) {
    for (int member = 0; member < members_; ++member) {
      state_.parameters.segment(member * layout_.size(), layout_.arm_offset(0)) *=
          float(1.0 - rate * settings_.weight_decay);
    }
  }
}

EpochLoss EpochTrainer::train_slice(const TrainingStage& stage,
                                    const std::function<bool()>& should_stop, EpochSums& sums) {
  BatchGradient& gradient = gradient_for(stage);
  const std::vector<int> starts = shuffled_starts(stage);
  const auto batch = std::size_t(stage.windows_per_batch);
  const bool summed = settings_.reduction == LossReduction::sum_over_batch;
  for (std::size_t first = 0; first < starts.size(); first += batch) {
    if (should_stop && should_stop()) {
      return {.stopped = true};
    }
    const std::size_t count = std::min(batch, starts.size() - first);
    const std::span<const double> losses =
        gradient.compute(std::span(starts).subspan(first, count), state_.parameters, gradient_);
    for (int member = 0; member < members_; ++member) {
      const auto at = std::size_t(member);
      const double mean = losses[at] / double(count);
      if (state_.stage_first_loss.size() <= at) {
        state_.stage_first_loss.push_back(mean);
      }
      if (!std::isfinite(mean) || mean > kExplosion * state_.stage_first_loss[at]) {
        return {mean, member, mean};
      }
      sums.losses[at] += losses[at];
    }
    const double progress = double(first) / double(starts.size());
    step(summed ? 1.0 : 1.0 / double(count),
         learning_rate(state_.epochs_done + (slice_ + progress) / slice_count_));
  }
  sums.windows += starts.size();
  return {};
}

EpochLoss EpochTrainer::train_epoch(const TrainingStage& stage,
                                    const std::function<bool()>& should_stop) {
  EpochSums sums;
  sums.losses.assign(std::size_t(members_), 0.0);
  int slice = 0;
  do {
    load(slice);
    const EpochLoss loss = train_slice(stage, should_stop, sums);
    if (loss.stopped || loss.diverged >= 0) {
      return loss;
    }
  } while (++slice < slice_count_);
  assert(sums.windows > 0);  // the constructor refuses stages that have none
  EpochLoss result;
  for (int member = 0; member < members_; ++member) {
    const double mean = sums.losses[member] / double(sums.windows);
    result.mean += mean / members_;
    if (mean > kWorsening * state_.stage_first_loss[member]) {
      result.diverged = member;
      result.diverged_loss = mean;
    }
  }
  return result;
}

void EpochTrainer::rehearse(const TrainingStage& stage, std::span<const int> starts) {
  gradient_for(stage).compute(starts, state_.parameters, gradient_);
  const OptimiserState before = state_.optimiser;
  // The first step alone begins SOAP's averages: it costs many of the others.
  state_.optimiser.step = std::max<std::int64_t>(state_.optimiser.step, 1);
  step(0.0, 0.0);
  state_.optimiser = before;
}

CompensationModel EpochTrainer::model_of_member(const Eigen::VectorXf& parameters,
                                                int member) const {
  return model_of(parameters, std::span(&member, 1));
}

CompensationModel EpochTrainer::model_of(const Eigen::VectorXf& parameters,
                                         std::span<const int> order) const {
  CompensationModel model;
  model.layout = settings_.layout;
  model.form = settings_.form;
  model.reads_velocity = settings_.reads_velocity;
  model.past_commands = past_commands_of(arm_, settings_);
  for (const int member : order) {
    std::vector<Layer> layers =
        to_layers(layout_, parameters.segment(member * layout_.size(), layout_.size()));
    if (model.layers.empty()) {
      model.layers = std::move(layers);
    } else {
      model.more_members.push_back(std::move(layers));
    }
  }
  if (layout_.arms().size > 0) {
    make_family(layout_, parameters, model);
  }
  model.input = tables_.input;
  model.output = tables_.output;
  model.set_arm(arm_);
  model.learnt_from_setpoints = survey_.from_setpoints;
  model.preset = settings_.preset;
  if (settings_.bounded) {
    model.bounds = survey_.bounds;
  }
  return model;
}

}  // namespace limber
