#include "run_roles.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kRunsPerTurn = 10;
constexpr int kStillFrames = 5;  // one more than training/error_runs.cpp asks of an arm at rest

void add(TrainingData& data, RunRole role, Episode episode) {
  switch (role) {
    case RunRole::validation:
      data.validation.push_back(std::move(episode));
      break;
    case RunRole::held_back:
      data.unseen.push_back(std::move(episode));
      break;
    default:
      data.training.push_back(std::move(episode));
      break;
  }
}

/// `count` times the first row of `rows`, then `rows`.
template <class Matrix>
Matrix with_first_row_repeated(const Matrix& rows, int count) {
  Matrix result(rows.rows() + count, rows.cols());
  result.topRows(count).rowwise() = rows.row(0);
  result.bottomRows(rows.rows()) = rows;
  return result;
}

}  // namespace

RunRole role_of(int index) {
  switch (index % kRunsPerTurn) {
    case 1:
      return RunRole::validation;
    case 2:
    case 7:
      return RunRole::held_back;
    default:
      return RunRole::training;
  }
}

void RoundData::add_exploration(const std::vector<Episode>& episodes) {
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    add(data, role_of(static_cast<int>(i)), episodes[i]);
  }
}

void RoundData::add_plans(const std::vector<Episode>& episodes, double frame_period_s) {
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const RunRole role = role_of(static_cast<int>(i));
    add(data, role,
        role == RunRole::held_back ? as_motion_from_rest(episodes[i], frame_period_s)
                                   : episodes[i]);
  }
}

void RoundData::hold_back(const std::vector<Episode>& plans, const std::vector<Episode>& motions,
                          double frame_period_s) {
  for (const Episode& plan : plans) {
    data.unseen.push_back(as_motion_from_rest(plan, frame_period_s));
  }
  data.unseen.insert(data.unseen.end(), motions.begin(), motions.end());
}

Episode as_motion_from_rest(const Episode& plan, double frame_period_s) {
  Episode result;
  const int frames = plan.frame_count();
  result.time_s.resize(frames + kStillFrames);
  for (int t = 0; t < kStillFrames; ++t) {
    result.time_s[t] = plan.time_s[0] + t * frame_period_s;
  }
  result.time_s.tail(frames) = plan.time_s.array() + kStillFrames * frame_period_s;
  result.pressure_kpa = with_first_row_repeated(plan.pressure_kpa, kStillFrames);
  result.setpoint_kpa = with_first_row_repeated(plan.setpoint_kpa, kStillFrames);
  result.backbone = with_first_row_repeated(plan.backbone, kStillFrames);
  result.motion_index.assign(static_cast<std::size_t>(frames + kStillFrames), 1);
  std::fill_n(result.motion_index.begin(), kStillFrames + 1, 0);
  if (!plan.tracked.empty()) {
    result.tracked.assign(kStillFrames, plan.tracked.front());
    result.tracked.insert(result.tracked.end(), plan.tracked.begin(), plan.tracked.end());
  }
  return result;
}

}  // namespace limber
