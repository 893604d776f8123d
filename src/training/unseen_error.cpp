#include "limber/training/unseen_error.hpp"

#include <algorithm>
#include <cmath>

#include "episode_slice.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "limber/training/rollout.hpp"

namespace limber {

namespace {

/// The first frame in which the arm was seen, `frame` or later; frame_count() where there is none.
int next_seen(const Episode& episode, int frame) {
  while (frame < episode.frame_count() && !episode.was_tracked(frame)) {
    ++frame;
  }
  return frame;
}

/// Frames after the first of every run; 0 where there is nothing to predict.
int run_frames(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  std::vector<int> lengths;
  for (const Episode& episode : episodes) {
    lengths.push_back(episode.frame_count() - 1 - next_seen(episode, 0));
  }
  std::erase_if(lengths, [](int length) { return length < 1; });
  if (lengths.empty()) {
    return 0;
  }
  // The lower median: half of the episodes or more are long enough.
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>((lengths.size() - 1) / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return std::min(static_cast<int>(std::lround(kErrorRun_s * arm.frame_rate_hz)), *middle);
}

/// The runs as episodes, their pressures those that the model's valves make of the set points.
std::vector<Episode> runs_of(const ArmDescription& arm, const CompensationModel& model,
                             const std::vector<Episode>& unseen, int frames) {
  const ValveParameters valves = model.valves.value_or(ValveParameters{});
  const bool measured = setpoints_are_measured(unseen);
  std::vector<Episode> runs;
  for (const Episode& episode : unseen) {
    int first = next_seen(episode, 0);
    while (first + frames < episode.frame_count()) {
      Episode run = slice(episode, first, frames + 1);
      if (!measured) {
        run.pressure_kpa = simulate_valves(valves, arm.frame_rate_hz, episode, first, frames + 1);
      }
      runs.push_back(std::move(run));
      first = next_seen(episode, first + frames);
    }
  }
  return runs;
}

struct RunError {
  double largest_position_m = 0.0;
  double end_position_m = 0.0;
  double end_orientation_rad = 0.0;
};

/// None where the arm was seen in no frame after the first.
std::optional<RunError> error_of(const FrameMatrix& predicted, const Episode& run) {
  std::optional<RunError> error;
  for (int t = 1; t < run.frame_count(); ++t) {
    if (!run.was_tracked(t)) {
      continue;
    }
    const Eigen::MatrixX3d apart = (predicted.row(t) - run.backbone.row(t))
                                       .cast<double>()
                                       .reshaped<Eigen::RowMajor>(run.backbone.cols() / 3, 3);
    const Eigen::VectorXd distance_m = apart.leftCols<2>().rowwise().norm();
    error = error.value_or(RunError{});
    error->largest_position_m = std::max(error->largest_position_m, distance_m.maxCoeff());
    error->end_position_m = distance_m[distance_m.size() - 1];
    error->end_orientation_rad = std::abs(apart(apart.rows() - 1, 2));
  }
  return error;
}

}  // namespace

std::optional<PredictionError> measure_prediction_error(const ArmDescription& arm,
                                                        const CompensationModel& model,
                                                        const std::vector<Episode>& unseen,
                                                        int jobs) {
  const int frames = run_frames(arm, unseen);
  if (frames == 0) {
    return std::nullopt;
  }
  const std::vector<Episode> runs = runs_of(arm, model, unseen, frames);
  std::vector<RolloutPiece> pieces;
  for (int i = 0; i < static_cast<int>(runs.size()); ++i) {
    pieces.push_back({i, 0, frames});
  }
  const std::vector<FrameMatrix> predicted = roll_out(ForwardModel(arm, model), runs, pieces, jobs);
  std::vector<double> largest_m;
  std::vector<double> end_m;
  std::vector<double> end_rad;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!predicted[i].bottomRows(frames).allFinite()) {
      return std::nullopt;
    }
    if (const std::optional<RunError> error = error_of(predicted[i], runs[i])) {
      largest_m.push_back(error->largest_position_m);
      end_m.push_back(error->end_position_m);
      end_rad.push_back(error->end_orientation_rad);
    }
  }
  if (largest_m.empty()) {
    return std::nullopt;
  }
  PredictionError result;
  result.runs = static_cast<int>(largest_m.size());
  result.run_s = frames * arm.frame_period_s();
  result.largest_position_m = conformal_quantile(largest_m);
  result.end_position_m = conformal_quantile(end_m);
  result.end_orientation_rad = conformal_quantile(end_rad);
  return result;
}

}  // namespace limber
