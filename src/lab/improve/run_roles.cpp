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
  for (const Episode& chain : episodes) {
    const RunRole role = role_of(chains++);
    add(data, role,
        role == RunRole::held_back ? as_motions_from_rest(chain, frame_period_s) : chain);
  }
}

void RoundData::hold_back(const std::vector<Episode>& plans, const std::vector<Episode>& motions,
                          double frame_period_s) {
  for (const Episode& plan : plans) {
    data.unseen.push_back(as_motions_from_rest(plan, frame_period_s));
  }
  data.unseen.insert(data.unseen.end(), motions.begin(), motions.end());
}

Episode as_motions_from_rest(const Episode& plans, double frame_period_s) {
  Episode result;
  const int frames = plans.frame_count();
  result.time_s.resize(frames + kStillFrames);
  for (int t = 0; t < kStillFrames; ++t) {
    result.time_s[t] = plans.time_s[0] + t * frame_period_s;
  }
  result.time_s.tail(frames) = plans.time_s.array() + kStillFrames * frame_period_s;
  result.pressure_kpa = with_first_row_repeated(plans.pressure_kpa, kStillFrames);
  result.setpoint_kpa = with_first_row_repeated(plans.setpoint_kpa, kStillFrames);
  result.backbone = with_first_row_repeated(plans.backbone, kStillFrames);
  result.motion_index.assign(kStillFrames + 1, 0);
  std::transform(plans.motion_index.begin() + 1, plans.motion_index.end(),
                 std::back_inserter(result.motion_index), [](int motion) { return motion + 1; });
  if (!plans.tracked.empty()) {
    result.tracked.assign(kStillFrames, plans.tracked.front());
    result.tracked.insert(result.tracked.end(), plans.tracked.begin(), plans.tracked.end());
  }
  return result;
}

}  // namespace limber
