#include "limber/training/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "learnt_kind.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/units.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr int kWindowFrames = 32;
constexpr int kMinFrames = 3;  // constant velocity needs two frames before the one it predicts

std::vector<RolloutPiece> pieces_for(const std::vector<Episode>& episodes, Restart restart) {
  switch (restart) {
    case Restart::every_frame:
      return pieces_of_length(episodes, 1);
    case Restart::every_32_frames:
      return pieces_of_length(episodes, kWindowFrames);
    case Restart::every_motion:
      return pieces_of_motions(episodes);
    case Restart::at_the_start_only:
      break;
  }
  return pieces_of_length(episodes, std::numeric_limits<int>::max());
}

/// A piece for every frame but the first, whether a start was tracked or not: for models that need
/// none.
std::vector<RolloutPiece> pieces_of_every_frame(const std::vector<Episode>& episodes) {
  std::vector<RolloutPiece> pieces;
  for (int index = 0; index < static_cast<int>(episodes.size()); ++index) {
    for (int t = 1; t < episodes[static_cast<std::size_t>(index)].frame_count(); ++t) {
      pieces.push_back({index, t - 1, 1});
    }
  }
  return pieces;
}

TipErrorSeries errors_over(const std::vector<FrameMatrix>& predicted,
                           const std::vector<Episode>& episodes, int first) {
  TipErrorSeries all;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    append(all, tip_errors(predicted[i], episodes[i], first));
  }
  return all;
}

/// @throws InputError if a prediction within the pieces is not finite.
void require_finite(const std::vector<FrameMatrix>& predicted,
                    const std::vector<RolloutPiece>& pieces) {
  for (const RolloutPiece& piece : pieces) {
    const FrameMatrix& frames = predicted[static_cast<std::size_t>(piece.episode)];
    for (int t = piece.first + 1; t <= piece.first + piece.frames; ++t) {
      if (!frames.row(t).allFinite()) {
        throw InputError(
            fmt::format("the model's prediction of {} is not finite from {} on: its weights or "
                        "the recording's numbers are too large",
                        episode_name(piece.episode), frame_name(t)));
      }
    }
  }
}

std::vector<FrameMatrix> predict_checked(const ForwardModel& model,
                                         const std::vector<Episode>& episodes, Restart restart,
                                         int jobs) {
  const std::vector<RolloutPiece> pieces =
      model.has_network() ? pieces_for(episodes, restart) : pieces_of_every_frame(episodes);
  if (model.has_network()) {
    require_kind_learnt(model.compensation(), episodes);
  }
  std::vector<FrameMatrix> predicted = roll_out(model, episodes, pieces, jobs, OnInterrupt::stop);
  require_finite(predicted, pieces);
  return predicted;
}

TipErrorSeries rollout_errors(const ForwardModel& model, const std::vector<Episode>& episodes,
                              Restart restart, int jobs) {
  return errors_over(predict_checked(model, episodes, restart, jobs), episodes, 1);
}

/// Makes predictions NaN that depend on an untracked frame among the `count` frames before them.
void forget_guesses(const Episode& episode, int count, FrameMatrix& predicted) {
  for (int t = 0; t < episode.frame_count(); ++t) {
    for (int before = std::max(t - count, 0); before < t; ++before) {
      if (!episode.was_tracked(before)) {
        predicted.row(t).setConstant(std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
}

std::vector<FrameMatrix> hold(const std::vector<Episode>& episodes) {
  std::vector<FrameMatrix> predicted;
  for (const Episode& episode : episodes) {
    const Eigen::Index frames = episode.backbone.rows();
    FrameMatrix held = episode.backbone;
    held.bottomRows(frames - 1) = episode.backbone.topRows(frames - 1);
    forget_guesses(episode, 1, held);
    predicted.push_back(std::move(held));
  }
  return predicted;
}

std::vector<FrameMatrix> constant_velocity(const std::vector<Episode>& episodes) {
  std::vector<FrameMatrix> predicted;
  for (const Episode& episode : episodes) {
    const Eigen::Index frames = episode.backbone.rows();
    FrameMatrix moved = episode.backbone;
    moved.bottomRows(frames - 2) =
        2.0F * episode.backbone.middleRows(1, frames - 2) - episode.backbone.topRows(frames - 2);
    forget_guesses(episode, 2, moved);
    predicted.push_back(std::move(moved));
  }
  return predicted;
}

double reduction_percent(double before, double after) {
  return before > 0.0 ? 100.0 * (1.0 - after / before) : 0.0;
}

}  // namespace

std::vector<FrameMatrix> predict(const ForwardModel& model, const std::vector<Episode>& episodes,
                                 Restart restart, int jobs) {
  require_episodes_of(episodes, model.no_load());
  return predict_checked(model, episodes, restart, jobs);
}

FrameMatrix predict(const ForwardModel& model, const Episode& episode, Restart restart, int jobs) {
  return std::move(predict(model, std::vector<Episode>{episode}, restart, jobs).front());
}

namespace {

/// Frames that count: those tracked after the first of their episode, which is given.
std::int64_t counted_frames(const std::vector<Episode>& episodes) {
  std::int64_t frames = 0;
  for (const Episode& episode : episodes) {
    for (int t = 1; t < episode.frame_count(); ++t) {
      frames += episode.was_tracked(t) ? 1 : 0;
    }
  }
  if (frames == 0) {
    throw InputError(
        "the recording can't be used for evaluation: the arm was tracked in none of the frames "
        "after the first of an episode");
  }
  return frames;
}

std::optional<TipErrors> errors_from_setpoints(const ForwardModel& network,
                                               std::vector<Episode> episodes, int jobs) {
  const std::optional<ValveParameters>& valves = network.compensation().valves;
  if (!valves || setpoints_are_measured(episodes)) {
    return std::nullopt;
  }
  for (Episode& episode : episodes) {
    const int frames = episode.frame_count();
    const double rate_hz = (frames - 1) / (episode.time_s[frames - 1] - episode.time_s[0]);
    episode.pressure_kpa = simulate_valves(*valves, rate_hz, episode);
  }
  return summarise(rollout_errors(network, episodes, Restart::at_the_start_only, jobs));
}

/// Two arms of equal sizes that differ in numbers alone would pass for one.
void require_models(const ForwardModel& no_load, const ForwardModel* network) {
  if (no_load.has_network() || (network != nullptr && !network->has_network())) {
    throw InputError(
        fmt::format("evaluate compares a no-load model and a network, in this order; found {} {}",
                    no_load.has_network() ? "a network" : "a no-load model",
                    network == nullptr        ? "alone"
                    : !network->has_network() ? "and a no-load model"
                                              : "and a network"));
  }
  if (network != nullptr && (network->segment_count() != no_load.segment_count() ||
                             network->point_count() != no_load.point_count())) {
    throw InputError(fmt::format(
        "the no-load model has {} segments and {} points, the network's arm {} and {}; expected "
        "models of one arm",
        no_load.segment_count(), no_load.point_count(), network->segment_count(),
        network->point_count()));
  }
}

}  // namespace

Evaluation evaluate(const ForwardModel& no_load, const ForwardModel* network,
                    const std::vector<Episode>& all_episodes, int jobs) {
  require_models(no_load, network);
  require_episodes_of(all_episodes, no_load.no_load());
  std::vector<Episode> episodes;
  std::int64_t frames = 0;
  for (const Episode& episode : all_episodes) {
    frames += episode.frame_count();
    if (episode.frame_count() >= kMinFrames) {
      episodes.push_back(episode);
    }
  }
  if (episodes.empty()) {
    throw InputError(
        fmt::format("the recording is too short for evaluation: {} frames in {} episodes; expected "
                    "an episode of at least {} frames",
                    frames, all_episodes.size(), kMinFrames));
  }
  Evaluation result;
  result.command = no_load.no_load().command();
  result.frames = counted_frames(episodes);
  // The no-load model has no memory: restarting it would change nothing.
  const auto errors_of = [&](const ForwardModel& model, Restart restart) {
    return summarise(rollout_errors(model, episodes, restart, jobs));
  };
  result.no_load_open_loop = errors_of(no_load, Restart::every_frame);
  const auto one_step = [](const TipErrorSeries& series, TipErrors& all, TipErrors& moving) {
    all = summarise(series);
    moving = summarise(moving_frames(series));
  };
  one_step(errors_over(hold(episodes), episodes, 1), result.hold_one_step,
           result.hold_one_step_moving);
  one_step(errors_over(constant_velocity(episodes), episodes, 2), result.constant_velocity_one_step,
           result.constant_velocity_one_step_moving);
  if (network != nullptr) {
    RolloutErrors errors;
    one_step(rollout_errors(*network, episodes, Restart::every_frame, jobs), errors.one_step,
             errors.one_step_moving);
    errors.window_32 = errors_of(*network, Restart::every_32_frames);
    errors.per_motion = errors_of(*network, Restart::every_motion);
    errors.open_loop = errors_of(*network, Restart::at_the_start_only);
    errors.open_loop_from_setpoints = errors_from_setpoints(*network, episodes, jobs);
    result.long_rollout = roll_out_long(*network, episodes);
    if (network->compensation().learnt) {
      result.novel = find_novel_frames(*network->compensation().learnt, episodes);
    }
    result.position_reduction_percent = reduction_percent(result.no_load_open_loop.position_cm.mean,
                                                          errors.open_loop.position_cm.mean);
    result.orientation_reduction_percent = reduction_percent(
        result.no_load_open_loop.orientation_rad.mean, errors.open_loop.orientation_rad.mean);
    result.network = errors;
  }
  return result;
}

}  // namespace limber
