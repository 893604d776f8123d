#include "limber/training/unseen_error.hpp"

#include <algorithm>
#include <cmath>

#include "episode_slice.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/rollout.hpp"

namespace limber {

namespace {

constexpr int kPathFrames = 8;    // before and after: late or early by that much is no other path
constexpr float kStillM = 1e-3F;  // of any plate from frame to frame
constexpr int kStillFrames = 4;   // in a row
constexpr std::size_t kFewestFromRest = 19;  // for a 95 % quantile
constexpr int kPathParts = 4;                // places looked at between two frames

/// The first frame in which the arm was seen, `frame` or later; frame_count() where there is none.
int next_seen(const Episode& episode, int frame) {
  while (frame < episode.frame_count() && !episode.was_tracked(frame)) {
    ++frame;
  }
  return frame;
}

/// Whether anything is commanded to move: standing still is easily predicted.
bool moves(const Episode& episode, int first, int last) {
  return (episode.setpoint_kpa.middleRows(first + 1, last - first).rowwise() -
          episode.setpoint_kpa.row(first))
             .cwiseAbs()
             .maxCoeff() > 0.0F;
}

/// Calls visit(first, last) for every run of an episode: a motion as it was recorded, its hold
/// included, at most `most_frames` long; where that is longer, it is cut.
template <class Visit>
void visit_runs(const Episode& episode, int most_frames, Visit&& visit) {
  const auto motion = [&](int frame) {
    return episode.motion_index[static_cast<std::size_t>(frame)];
  };
  int first = next_seen(episode, 0);
  while (first + 1 < episode.frame_count()) {
    int last = first + 1;
    while (last + 1 < episode.frame_count() && last - first < most_frames &&
           motion(last + 1) == motion(first + 1)) {
      ++last;
    }
    if (moves(episode, first, last)) {
      visit(first, last);
    }
    first = next_seen(episode, last);
  }
}

/// Whether the arm had come to rest in frame `frame`, as it has before a plan.
bool stands_still(const Episode& episode, int frame) {
  if (frame < kStillFrames) {
    return false;
  }
  for (int k = frame - kStillFrames; k < frame; ++k) {
    const Eigen::RowVectorXf way = episode.backbone.row(k + 1) - episode.backbone.row(k);
    const Eigen::MatrixX3f plates = way.reshaped<Eigen::RowMajor>(way.size() / 3, 3);
    if (plates.leftCols<2>().rowwise().norm().maxCoeff() > kStillM) {
      return false;
    }
  }
  return true;
}

struct RunPlace {
  const Episode* episode;
  int first;
  int last;
};

/// Those that begin as plans do, from an arm that stands; all of them where those are too few.
std::vector<RunPlace> places_of_runs(const ArmDescription& arm,
                                     const std::vector<Episode>& unseen) {
  const int most_frames = static_cast<int>(std::lround(kLongestErrorRun_s * arm.frame_rate_hz));
  std::vector<RunPlace> all;
  std::vector<RunPlace> from_rest;
  for (const Episode& episode : unseen) {
    visit_runs(episode, most_frames, [&](int first, int last) {
      all.push_back({&episode, first, last});
      if (stands_still(episode, first)) {
        from_rest.push_back(all.back());
      }
    });
  }
  return from_rest.size() >= kFewestFromRest ? from_rest : all;
}

/// The runs as episodes, their pressures those that the model's valves make of the set points.
std::vector<Episode> runs_of(const ArmDescription& arm, const CompensationModel& model,
                             const std::vector<Episode>& unseen) {
  const ValveParameters valves = model.valves.value_or(ValveParameters{});
  const bool measured = setpoints_are_measured(unseen);
  std::vector<Episode> runs;
  for (const RunPlace& place : places_of_runs(arm, unseen)) {
    const int count = place.last - place.first + 1;
    Episode run = slice(*place.episode, place.first, count);
    if (!measured) {
      run.pressure_kpa =
          simulate_valves(valves, arm.frame_rate_hz, *place.episode, place.first, count);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

struct RunError {
  double largest_position_m = 0.0;
  double off_path_m = 0.0;
  double end_position_m = 0.0;
  double end_orientation_rad = 0.0;
};

/// Two shapes side by side, plates in rows.
Eigen::MatrixX3d apart_of(const Eigen::RowVectorXf& a, const Eigen::RowVectorXf& b) {
  return (a - b).cast<double>().reshaped<Eigen::RowMajor>(a.size() / 3, 3);
}

double largest_distance_m(const Eigen::RowVectorXf& a, const Eigen::RowVectorXf& b) {
  return apart_of(a, b).leftCols<2>().rowwise().norm().maxCoeff();
}

/// From the shape in frame `t` to the nearest predicted for about then, between frames too.
double off_path_m(const FrameMatrix& predicted, const Episode& run, int t) {
  const int first = std::max(0, t - kPathFrames);
  const int last = std::min(run.frame_count() - 1, t + kPathFrames);
  double nearest = largest_distance_m(predicted.row(t), run.backbone.row(t));
  for (int k = first; k < last; ++k) {
    for (int part = 0; part < kPathParts; ++part) {
      const float fraction = float(part) / float(kPathParts);
      const Eigen::RowVectorXf between =
          (1.0F - fraction) * predicted.row(k) + fraction * predicted.row(k + 1);
      nearest = std::min(nearest, largest_distance_m(between, run.backbone.row(t)));
    }
  }
  return nearest;
}

/// None where the arm was seen in no frame after the first.
std::optional<RunError> error_of(const FrameMatrix& predicted, const Episode& run) {
  std::optional<RunError> error;
  for (int t = 1; t < run.frame_count(); ++t) {
    if (!run.was_tracked(t)) {
      continue;
    }
    const Eigen::MatrixX3d apart = apart_of(predicted.row(t), run.backbone.row(t));
    const Eigen::VectorXd distance_m = apart.leftCols<2>().rowwise().norm();
    error = error.value_or(RunError{});
    error->largest_position_m = std::max(error->largest_position_m, distance_m.maxCoeff());
    error->off_path_m = std::max(error->off_path_m, off_path_m(predicted, run, t));
    error->end_position_m = distance_m[distance_m.size() - 1];
    error->end_orientation_rad = std::abs(apart(apart.rows() - 1, 2));
  }
  return error;
}

}  // namespace

namespace {

/// Runs, and what the model predicts of them.
struct PredictedRuns {
  std::vector<Episode> runs;
  std::vector<FrameMatrix> predicted;

  bool are_finite() const {
    return std::ranges::all_of(predicted, [](const FrameMatrix& one) { return one.allFinite(); });
  }
};

PredictedRuns predict_runs(const ArmDescription& arm, const CompensationModel& model,
                           const std::vector<Episode>& unseen, int jobs) {
  PredictedRuns result{runs_of(arm, model, unseen), {}};
  std::vector<RolloutPiece> pieces;
  for (const Episode& run : result.runs) {
    pieces.push_back({static_cast<int>(pieces.size()), 0, run.frame_count() - 1});
  }
  result.predicted = roll_out(ForwardModel(arm, model), result.runs, pieces, jobs);
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    result.predicted[i].row(0) = result.runs[i].backbone.row(0);  // where it starts is known
  }
  return result;
}

std::optional<PredictionError> error_of(const ArmDescription& arm, const PredictedRuns& all) {
  std::vector<double> largest_m, off_m, end_m, end_rad;
  double frames = 0.0;
  for (std::size_t i = 0; i < all.runs.size(); ++i) {
    if (const std::optional<RunError> error = error_of(all.predicted[i], all.runs[i])) {
      largest_m.push_back(error->largest_position_m);
      off_m.push_back(error->off_path_m);
      end_m.push_back(error->end_position_m);
      end_rad.push_back(error->end_orientation_rad);
      frames += all.runs[i].frame_count() - 1;
    }
  }
  if (largest_m.empty()) {
    return std::nullopt;
  }
  PredictionError result;
  result.runs = static_cast<int>(largest_m.size());
  result.run_s = frames / result.runs * arm.frame_period_s();
  result.largest_position_m = conformal_quantile(largest_m);
  result.off_path_m = conformal_quantile(off_m);
  result.end_position_m = conformal_quantile(end_m);
  result.end_orientation_rad = conformal_quantile(end_rad);
  return result;
}

}  // namespace

std::optional<PredictionError> measure_prediction_error(const ArmDescription& arm,
                                                        const CompensationModel& model,
                                                        const std::vector<Episode>& unseen,
                                                        int jobs) {
  const PredictedRuns all = predict_runs(arm, model, unseen, jobs);
  return all.are_finite() ? error_of(arm, all) : std::nullopt;
}

void note_unseen(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& unseen, int jobs) {
  PredictedRuns all = predict_runs(arm, model, unseen, jobs);
  model.prediction_error = all.are_finite() ? error_of(arm, all) : std::nullopt;
  if (!model.prediction_error || !model.learnt) {
    return;
  }
  for (std::size_t i = 0; i < all.runs.size(); ++i) {
    all.runs[i].backbone = all.predicted[i];
    all.runs[i].tracked.clear();
  }
  model.learnt = widened_by(std::move(*model.learnt), all.runs);
}

}  // namespace limber
