#include "plan_improver.hpp"

#include <algorithm>
#include <cmath>

#include "limber/arm/inverse_kinematics.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kImproverStream = 2;
constexpr double kImprovementKpa = 1e-4;
constexpr double kLargestShift = 0.3;  // standard deviation, of the limit
constexpr double kSmallestShift = 0.002;

double path_cost(const std::vector<Pressures>& waypoints_kpa) {
  double cost = 0.0;
  for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
    cost += motion_cost_kpa(waypoints_kpa[i - 1], waypoints_kpa[i]);
  }
  return cost;
}

}  // namespace

PlanImprover::PlanImprover(const PlanningProblem& problem, MotionSimulator& simulator,
                           std::uint64_t seed)
    : problem_(problem),
      simulator_(simulator),
      random_(seed, kImproverStream),
      limit_kpa_(problem.arm.segment_count()) {
  for (int i = 0; i < limit_kpa_.size(); ++i) {
    limit_kpa_[i] =
        static_cast<float>(problem.arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa);
  }
}

void PlanImprover::adopt(const std::vector<Pressures>& waypoints_kpa) {
  waypoints_kpa_ = waypoints_kpa;
  cost_kpa_ = path_cost(waypoints_kpa_);
  backbones_.assign(1, start_state(problem_.environment, problem_.arm).backbone);
  for (std::size_t i = 1; i < waypoints_kpa_.size(); ++i) {
    Backbone end(problem_.arm.point_count(), 3);
    simulator_.move_unchecked(waypoints_kpa_[i - 1], backbones_.back(), waypoints_kpa_[i], end);
    backbones_.push_back(std::move(end));
  }
}

/// Removes one to a few waypoints in a row; start and end stay.
void PlanImprover::leave_out() {
  const auto inner = static_cast<std::uint32_t>(candidate_kpa_.size()) - 2;
  const std::uint32_t first = 1 + random_.index(inner);
  const std::uint32_t most = inner + 1 - first;
  const std::uint32_t count = 1 + random_.index(std::min(most, 4U));
  candidate_kpa_.erase(candidate_kpa_.begin() + first, candidate_kpa_.begin() + first + count);
}

/// Runs one segment's pressure evenly between two waypoints: the cost counts reversals only.
void PlanImprover::straighten() {
  const auto count = static_cast<std::uint32_t>(candidate_kpa_.size());
  const std::uint32_t first = random_.index(count - 2);
  const std::uint32_t last = first + 2 + random_.index(count - first - 2);
  const auto segment =
      static_cast<Eigen::Index>(random_.index(static_cast<std::uint32_t>(limit_kpa_.size())));
  const float from = candidate_kpa_[first][segment];
  const float to = candidate_kpa_[last][segment];
  for (std::uint32_t i = first + 1; i < last; ++i) {
    candidate_kpa_[i][segment] = from + (to - from) * float(i - first) / float(last - first);
  }
}

/// Normal, of a scale drawn evenly in its logarithm, along all segments or one of them.
Pressures PlanImprover::random_shift() {
  const double scale = kSmallestShift * std::pow(kLargestShift / kSmallestShift, random_.uniform());
  const auto n = static_cast<std::uint32_t>(limit_kpa_.size());
  const std::uint32_t only = random_.index(2 * n);  // ≥ n: all of them
  Pressures shift = Pressures::Zero(limit_kpa_.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (only >= n || only == i) {
      shift[i] = static_cast<float>(random_.normal() * scale) * limit_kpa_[i];
    }
  }
  return shift;
}

void PlanImprover::shift_one() {
  const std::size_t i = 1 + random_.index(static_cast<std::uint32_t>(candidate_kpa_.size()) - 1);
  candidate_kpa_[i] =
      (candidate_kpa_[i] + random_shift()).cwiseMax(-limit_kpa_).cwiseMin(limit_kpa_);
}

/// Shifts the end, and the waypoints before it in proportion to how far along they are.
void PlanImprover::shift_end() {
  const Pressures shift = random_shift();
  const auto last = static_cast<float>(candidate_kpa_.size() - 1);
  for (std::size_t i = 1; i < candidate_kpa_.size(); ++i) {
    candidate_kpa_[i] =
        (candidate_kpa_[i] + shift * (float(i) / last)).cwiseMax(-limit_kpa_).cwiseMin(limit_kpa_);
  }
}

bool PlanImprover::candidate_is_solution() {
  std::size_t same = 1;
  while (same < candidate_kpa_.size() && same < waypoints_kpa_.size() &&
         candidate_kpa_[same] == waypoints_kpa_[same]) {
    ++same;
  }
  candidate_backbones_.assign(backbones_.begin(),
                              backbones_.begin() + static_cast<std::ptrdiff_t>(same));
  Backbone end(problem_.arm.point_count(), 3);
  for (std::size_t i = same; i < candidate_kpa_.size(); ++i) {
    if (!simulator_.move(candidate_kpa_[i - 1], candidate_backbones_.back(), candidate_kpa_[i],
                         end)) {
      return false;
    }
    candidate_backbones_.push_back(end);
  }
  return simulator_.hold(candidate_kpa_.back(), candidate_backbones_.back(),
                         hold_frame_count(problem_.arm), end) &&
         is_within(problem_.environment.goal, pose_error(problem_.environment.goal, tip_pose(end)));
}

bool PlanImprover::try_once() {
  if (waypoints_kpa_.size() < 2) {
    return false;  // the start is in the goal
  }
  candidate_kpa_ = waypoints_kpa_;
  const std::uint32_t kind = random_.index(4);
  if (candidate_kpa_.size() > 2 && kind == 0) {
    leave_out();
  } else if (candidate_kpa_.size() > 2 && kind == 1) {
    straighten();
  } else if (kind == 2) {
    shift_end();
  } else {
    shift_one();
  }
  const double cost = path_cost(candidate_kpa_);
  if (cost >= cost_kpa_ - kImprovementKpa || !candidate_is_solution()) {
    return false;
  }
  cost_kpa_ = cost;
  waypoints_kpa_.swap(candidate_kpa_);
  backbones_.swap(candidate_backbones_);
  return true;
}

}  // namespace limber
