#include "limber/training/unseen_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "learnt_kind.hpp"
#include "limber/arm/plate_distance.hpp"
#include "limber/common/mapped.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/run_errors.hpp"
#include "rollout.hpp"

namespace limber {

namespace {

constexpr int kPathFrames = 8;  // before and after: a delay up to this is still the same path
constexpr int kWholeEpisodes = std::numeric_limits<int>::max();
constexpr int kPathParts = 4;  // points checked from one frame to the next

constexpr double kStillM = 1e-3;          // of any plate from frame to frame
constexpr int kStillFrames = 4;           // in a row
constexpr std::size_t kMinFromRest = 19;  // for a 95 % quantile

/// Whether anything is commanded to move: standing still is easily predicted.
/// @param noise  of commands, as a share of half their range
bool moves(const ArmDescription& arm, const Episode& episode, const RolloutPiece& piece,
           double noise) {
  for (int i = 0; i < arm.channel_count(); ++i) {
    const auto commands = episode.setpoint_kpa.col(i).segment(piece.first, piece.frames + 1);
    if (double((commands.array() - commands[0]).abs().maxCoeff()) >
        noise * arm.limits_of_channel(i).half_width_kpa()) {
      return true;
    }
  }
  return false;
}

/// Whether the arm was seen to have come to rest in frame `frame`, as it has before a plan.
bool stands_still(const Episode& episode, int frame) {
  if (frame < kStillFrames) {
    return false;
  }
  for (int k = frame - kStillFrames; k < frame; ++k) {
    if (!episode.was_tracked(k) || !episode.was_tracked(k + 1) ||
        largest_place_distance_m(places_at(episode.backbone, k + 1, episode.dimension),
                                 places_at(episode.backbone, k, episode.dimension)) > kStillM) {
      return false;
    }
  }
  return true;
}

/// The runs over which a model's error is measured: recorded motions, cut at kLongestErrorRun_s,
/// that move a set point; if enough of them begin with the arm at rest, only those.
std::vector<RolloutPiece> error_runs(const ArmDescription& arm,
                                     const std::vector<Episode>& unseen) {
  const int max_frames = int(std::lround(kLongestErrorRun_s * arm.frame_rate_hz));
  constexpr double kNoise = 0.02;  // of a sensor, where set points are what was measured
  const auto noise = mapped<double>(unseen, [&](const Episode& episode) {
    return !episode.setpoints_only && setpoints_are_measured(episode) ? kNoise : 0.0;
  });
  std::vector<RolloutPiece> moving;
  std::vector<RolloutPiece> from_rest;
  // Motions as they were recorded, including holds, cut if they are long.
  for (const RolloutPiece& piece : cut_pieces(pieces_of_motions(unseen), unseen, max_frames)) {
    const Episode& episode = unseen[piece.episode];
    if (moves(arm, episode, piece, noise[piece.episode])) {
      moving.push_back(piece);
      if (stands_still(episode, piece.first)) {
        from_rest.push_back(piece);
      }
    }
  }
  return from_rest.size() >= kMinFromRest ? from_rest : moving;
}

/// The pieces as episodes, their pressures those that the model's valves make of the set points.
/// @param leads  for each, the frames that it has before the piece: they say how fast the arm moves
///               at first, and what was commanded before
std::vector<Episode> runs_of(const ArmDescription& arm, const CompensationModel& model,
                             const std::vector<Episode>& unseen,
                             const std::vector<RolloutPiece>& pieces, std::vector<int>& leads) {
  const ValveParameters valves = model.valves.value_or(ValveParameters{});
  std::vector<bool> measured;
  for (const Episode& episode : unseen) {
    measured.push_back(setpoints_are_measured(episode));
  }
  std::vector<Episode> runs;
  for (const RolloutPiece& piece : pieces) {
    const Episode& episode = unseen[piece.episode];
    const int past = model.past_commands.empty() ? 0 : model.past_commands.back();
    const int first = std::max(std::min(before_start(episode, piece.first), piece.first - past), 0);
    leads.push_back(piece.first - first);
    const int count = leads.back() + piece.frames + 1;
    Episode run = slice(episode, first, count);
    if (!measured[piece.episode]) {
      run.pressure_kpa = simulate_valves(valves, arm.frame_rate_hz, episode, first, count);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

struct RunError {
  double max_position_m = 0.0;
  double off_path_m = 0.0;
  GrowingErrors errors;  // of plates off their path
};

/// The predicted shape nearest to that of frame `t`, of about then, between frames too.
FrameMatrix nearest_shape(const FrameMatrix& predicted, const Episode& run, int t) {
  const int first = std::max(0, t - kPathFrames);
  const int last = std::min(run.frame_count() - 1, t + kPathFrames);
  const Places shape = places_at(run.backbone, t, run.dimension);
  FrameMatrix nearest = places_at(predicted, t, run.dimension);
  double distance_m = largest_place_distance_m(nearest, shape);
  for (int k = first; k < last; ++k) {
    for (int part = 0; part < kPathParts; ++part) {
      const float fraction = float(part) / float(kPathParts);
      const FrameMatrix between = (1.0F - fraction) * places_at(predicted, k, run.dimension) +
                                  fraction * places_at(predicted, k + 1, run.dimension);
      if (const double there_m = largest_place_distance_m(between, shape); there_m < distance_m) {
        distance_m = there_m;
        nearest = between;
      }
    }
  }
  return nearest;
}

/// Adds a frame to the largest errors of each plate.
void add_plates(const FrameMatrix& predicted, const Places& seen, const Places& start,
                double arm_length_m, GrowingErrors& errors) {
  for (std::size_t g = 0; g < kStartShares.size(); ++g) {
    const RoomGrowth growth = growth_of(g, arm_length_m);
    std::vector<double>& largest_m = errors.of[g].plate_m;
    largest_m.resize(std::size_t(predicted.rows()), 0.0);
    double share = 1.0;
    for (Eigen::Index plate = 0; plate < predicted.rows(); ++plate) {
      const auto place = predicted.row(plate);
      share = growth.share_after(double((place - start.row(plate)).norm()));
      double& largest = largest_m[plate];
      largest = std::max(largest, double((place - seen.row(plate)).norm()) / share);
    }
    errors.tip_share[g] += share;
  }
}

/// None if the arm was tracked in no frame after the first.
std::optional<RunError> error_of(const FrameMatrix& predicted, const Episode& run,
                                 double arm_length_m) {
  std::optional<RunError> error;
  int frames = 0;
  for (int t = 1; t < run.frame_count(); ++t) {
    if (!run.was_tracked(t)) {
      continue;
    }
    ++frames;
    error = error.value_or(RunError{});
    const Places seen = places_at(run.backbone, t, run.dimension);
    const Places then = places_at(predicted, t, run.dimension);
    error->max_position_m = std::max(error->max_position_m, largest_place_distance_m(then, seen));
    const FrameMatrix nearest = nearest_shape(predicted, run, t);
    error->off_path_m = std::max(error->off_path_m, largest_place_distance_m(nearest, seen));
    add_plates(nearest, seen, places_at(predicted, 0, run.dimension), arm_length_m, error->errors);
    for (MotionErrors& errors : error->errors.of) {
      errors.end_m = (then - seen).bottomRows<1>().cast<double>().norm();
      errors.end_heading_rad = heading_apart_rad(predicted, run, t);
    }
  }
  for (std::size_t g = 0; error && g < kStartShares.size(); ++g) {
    error->errors.tip_share[g] /= frames;
  }
  return error;
}

/// Runs, and what the model predicts of them.
struct PredictedRuns {
  std::vector<Episode> runs;
  std::vector<FrameMatrix> predicted;

  bool are_finite() const {
    return std::ranges::all_of(predicted, [](const FrameMatrix& one) { return one.allFinite(); });
  }
};

/// @param pieces_to_run  asked of the episodes, once it is known that they can be
PredictedRuns predict_runs(const ArmDescription& arm, const CompensationModel& model,
                           const std::vector<Episode>& unseen, const auto& pieces_to_run,
                           int jobs) {
  validate(model, "the model");
  require_model_of(model, arm, "the model");
  require_episodes_of(unseen, arm, "unseen data");
  const std::vector<Episode> asked =
      model.learnt_from_setpoints ? with_setpoints_only(unseen) : unseen;
  require_kind_learnt(model, asked);
  std::vector<int> leads;
  PredictedRuns result{runs_of(arm, model, asked, pieces_to_run(asked), leads), {}};
  const auto pieces = mapped<RolloutPiece>(leads.size(), [&](std::size_t i) {
    return RolloutPiece{int(i), leads[i], result.runs[i].frame_count() - 1 - leads[i]};
  });
  result.predicted = roll_out(ForwardModel(arm, model), result.runs, pieces, jobs);
  for (std::size_t i = 0; i < leads.size(); ++i) {
    Episode& run = result.runs[i];
    const int count = run.frame_count() - leads[i];
    run = slice(run, leads[i], count);
    result.predicted[i] = FrameMatrix(result.predicted[i].bottomRows(count));
    result.predicted[i].row(0) = run.backbone.row(0);  // where it starts is known
  }
  return result;
}

PredictedRuns predict_error_runs(const ArmDescription& arm, const CompensationModel& model,
                                 const std::vector<Episode>& unseen, int jobs, int first) {
  const auto pieces = [&](const std::vector<Episode>& asked) {
    std::vector<RolloutPiece> runs = error_runs(arm, asked);
    std::erase_if(runs, [&](const RolloutPiece& run) {
      int start = run.first;
      for (int i = 0; i < run.episode; ++i) {
        start += asked[i].frame_count();
      }
      return start < first;
    });
    return runs;
  };
  return predict_runs(arm, model, unseen, pieces, jobs);
}

void add_all(const ArmDescription& arm, const PredictedRuns& all, RunErrors& errors) {
  for (std::size_t i = 0; i < all.runs.size(); ++i) {
    if (const std::optional<RunError> error =
            error_of(all.predicted[i], all.runs[i], arm.length_m())) {
      errors.add(error->max_position_m, error->off_path_m, error->errors,
                 all.runs[i].frame_count() - 1,
                 all.runs[i].pressure_kpa.colwise().mean().transpose());
    }
  }
}

std::optional<PredictionError> error_of(const ArmDescription& arm, const PredictedRuns& all) {
  RunErrors errors;
  add_all(arm, all, errors);
  return errors.result(arm.frame_period_s());
}

/// Widens what the model has learnt by the shapes that it predicts.
void hold_shapes(PredictedRuns all, CompensationModel& model) {
  if (!model.learnt) {
    return;
  }
  for (std::size_t i = 0; i < all.runs.size(); ++i) {
    all.runs[i].backbone = all.predicted[i];
    all.runs[i].tracked.clear();
  }
  model.learnt = with_shapes_of(std::move(*model.learnt), std::move(all.runs));
}

}  // namespace

bool RunErrors::add(const ArmDescription& arm, const CompensationModel& model,
                    const std::vector<Episode>& unseen, int jobs) {
  const PredictedRuns all = predict_error_runs(arm, model, unseen, jobs, 0);
  if (!all.are_finite()) {
    return false;
  }
  add_all(arm, all, *this);
  return true;
}

std::optional<PredictionError> measure_prediction_error(const ArmDescription& arm,
                                                        const CompensationModel& model,
                                                        const std::vector<Episode>& unseen,
                                                        int jobs, int first) {
  const PredictedRuns all = predict_error_runs(arm, model, unseen, jobs, first);
  return all.are_finite() ? error_of(arm, all) : std::nullopt;
}

void note_unseen(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& unseen, int jobs) {
  PredictedRuns all = predict_error_runs(arm, model, unseen, jobs, 0);
  model.prediction_error = all.are_finite() ? error_of(arm, all) : std::nullopt;
  if (model.prediction_error) {
    hold_shapes(std::move(all), model);
  }
}

void note_shapes(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& episodes, int jobs) {
  if (!model.learnt) {
    return;
  }
  const auto whole = [](const std::vector<Episode>& asked) {
    return pieces_of_length(asked, kWholeEpisodes);
  };
  if (PredictedRuns all = predict_runs(arm, model, episodes, whole, jobs); all.are_finite()) {
    hold_shapes(std::move(all), model);
  }
}

}  // namespace limber
