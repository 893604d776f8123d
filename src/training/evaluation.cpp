#include "limber/training/evaluation.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "learnt_kind.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr double kTrackerNoiseM = 0.0005;  // of a plate's place: that of a usual tracker
constexpr std::uint64_t kTrackerStream = 0x747261636b;
constexpr int kMinFrames = 3;  // constant velocity needs two frames before the one it predicts

/// A piece for every frame but the first, whether a start was tracked or not: for models that need
/// none.
std::vector<RolloutPiece> pieces_of_every_frame(const std::vector<Episode>& episodes) {
  std::vector<RolloutPiece> pieces;
  for (int index = 0; index < int(episodes.size()); ++index) {
    for (int t = 1; t < episodes[index].frame_count(); ++t) {
      pieces.push_back({index, t - 1, 1});
    }
  }
  return pieces;
}

/// @throws InputError if a prediction within the pieces is not finite.
void require_finite(const std::vector<FrameMatrix>& predicted,
                    const std::vector<RolloutPiece>& pieces) {
  for (const RolloutPiece& piece : pieces) {
    const FrameMatrix& frames = predicted[piece.episode];
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

TipErrors rollout_errors(const ForwardModel& model, const std::vector<Episode>& episodes,
                         Restart restart, int jobs) {
  return summarise(errors_over(predict_checked(model, episodes, restart, jobs), episodes));
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
  const std::int64_t frames = measured_frames(episodes, pieces_of_every_frame(episodes));
  refuse_if(frames == 0,
            "the recording can't be used for evaluation: the arm was tracked in none of the frames "
            "after the first of an episode");
  return frames;
}

std::optional<TipErrors> errors_from_setpoints(const ForwardModel& network,
                                               std::vector<Episode> episodes, int jobs) {
  const std::optional<ValveParameters>& valves = network.compensation().valves;
  if (!valves || setpoints_are_measured(episodes)) {
    return std::nullopt;
  }
  leave_out_measured_setpoints(episodes);
  for (Episode& episode : episodes) {
    const int frames = episode.frame_count();
    const double rate_hz = (frames - 1) / (episode.time_s[frames - 1] - episode.time_s[0]);
    episode.pressure_kpa = simulate_valves(*valves, rate_hz, episode);
  }
  return rollout_errors(network, episodes, Restart::at_the_start_only, jobs);
}

/// The episodes as a tracker would have seen them.
std::vector<Episode> with_tracker_noise(std::vector<Episode> episodes, Eigen::Index pose_size) {
  RandomStream random(1, kTrackerStream);
  const Eigen::Index places = pose_size == kPoseSize ? 2 : 3;
  for (Episode& episode : episodes) {
    for (Eigen::Index t = 0; t < episode.backbone.rows(); ++t) {
      for (Eigen::Index i = pose_size; i < episode.backbone.cols(); ++i) {
        const double noise_m = i % pose_size < places ? kTrackerNoiseM * random.normal() : 0.0;
        episode.backbone(t, i) += float(noise_m);
      }
    }
  }
  return episodes;
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
  refuse_if(network != nullptr && network->dimension() != no_load.dimension(),
            "a model of an arm in space and one in a plane; expected models of one arm");
  if (network != nullptr && (network->segment_count() != no_load.segment_count() ||
                             network->channel_count() != no_load.channel_count() ||
                             network->point_count() != no_load.point_count())) {
    throw InputError(fmt::format(
        "the no-load model has {} segments and {} points, the network's arm {} and {}; expected "
        "models of one arm",
        no_load.segment_count(), no_load.point_count(), network->segment_count(),
        network->point_count()));
  }
}

}  // namespace

double noise_multiplied(const ForwardModel& network, const std::vector<Episode>& episodes,
                        int jobs) {
  const Eigen::Index pose = pose_size(network.dimension());
  const auto after_one_step = [&](const std::vector<Episode>& from) {
    return roll_out(network, from, pieces_for(from, Restart::every_frame), jobs);
  };
  const std::vector<FrameMatrix> predicted = after_one_step(episodes);
  const std::vector<FrameMatrix> noisy = after_one_step(with_tracker_noise(episodes, pose));
  double sum_m2 = 0.0;
  std::int64_t count = 0;
  const Eigen::Index places = pose == kPoseSize ? 2 : 3;
  for (std::size_t e = 0; e < predicted.size(); ++e) {
    const FrameMatrix tip_off = (noisy[e] - predicted[e]).rightCols(pose).leftCols(places);
    for (Eigen::Index t = 0; t < tip_off.rows(); ++t) {
      if (tip_off.row(t).allFinite()) {
        sum_m2 += double(tip_off.row(t).squaredNorm());
        count += places;
      }
    }
  }
  return count > 0 ? std::sqrt(sum_m2 / double(count)) / kTrackerNoiseM : 0.0;
}

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
  refuse_if(episodes.empty(),
            "the recording is too short for evaluation: {} frames in {} episodes; expected "
            "an episode of at least {} frames",
            frames, all_episodes.size(), kMinFrames);
  Evaluation result;
  result.command = no_load.no_load().command();
  result.frames = counted_frames(episodes);
  // The no-load model has no memory: restarting it would change nothing.
  result.no_load_open_loop = rollout_errors(no_load, episodes, Restart::every_frame, jobs);
  const auto one_step = [&](const PiecePrediction& predict_piece, TipErrors& all,
                            TipErrors& moving) {
    const TipErrorSeries series = errors_over(
        predict_pieces(predict_piece, episodes, pieces_of_length(episodes, 1)), episodes);
    all = summarise(series);
    moving = summarise(moving_frames(series));
  };
  one_step(hold, result.hold_one_step, result.hold_one_step_moving);
  one_step(keep_velocity, result.constant_velocity_one_step,
           result.constant_velocity_one_step_moving);
  if (network != nullptr) {
    RolloutErrors errors = errors_at_every_restart(episodes, [&](Restart restart) {
      return predict_checked(*network, episodes, restart, jobs);
    });
    errors.open_loop_from_setpoints = errors_from_setpoints(*network, episodes, jobs);
    result.noise_multiplied = noise_multiplied(*network, episodes, jobs);
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
