#include "limber/lab/plan_spread.hpp"

#include <algorithm>
#include <cmath>

#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/forward/ensemble_forward.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

using Rollouts = std::vector<Eigen::MatrixXf>;  // one per member, 3m × frames

Eigen::Map<const Backbone> shape(const Eigen::MatrixXf& rollout, Eigen::Index frame) {
  return {rollout.col(frame).data(), rollout.rows() / kPoseSize, kPoseSize};
}

Rollouts roll_out(const Plan& plan, const EnsembleForward& ensemble) {
  const auto frames = Eigen::Index(plan.frames.size());
  const Backbone& start = plan.frames.front().backbone;
  Eigen::MatrixXf pressures(plan.frames.front().pressure_kpa.size(), frames);
  for (Eigen::Index k = 0; k < frames; ++k) {
    pressures.col(k) = plan.frames[k].pressure_kpa;
  }
  ForwardModel::Workspace workspace;
  Rollouts rollouts;
  for (int member = 0; member < ensemble.member_count(); ++member) {
    rollouts.emplace_back(start.size(), frames);
    rollouts.back().col(0) = Eigen::Map<const Eigen::VectorXf>(start.data(), start.size());
    ensemble.member(member).rollout(pressures, rollouts.back(), workspace);
  }
  return rollouts;
}

MemberFigures member_figures(const std::vector<double>& values) {
  return {*std::ranges::min_element(values), *std::ranges::max_element(values), mean(values),
          standard_deviation(values)};
}

SpreadAt spread_of_plate(const Rollouts& rollouts, int frame, int plate) {
  auto positions = mapped<Eigen::Vector2d>(rollouts, [&](const Eigen::MatrixXf& rollout) {
    return Eigen::Vector2d(shape(rollout, frame).row(plate).head(2).transpose().cast<double>());
  });
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& position : positions) {
    mean += position / double(positions.size());
  }
  SpreadAt result{frame, plate};
  double square = 0.0;
  for (const Eigen::Vector2d& position : positions) {
    square += (position - mean).squaredNorm() / double(positions.size());
    for (const Eigen::Vector2d& other : positions) {
      result.largest_distance_m = std::max(result.largest_distance_m, (position - other).norm());
    }
  }
  result.standard_deviation_m = std::sqrt(square);
  return result;
}

/// Of the plates from `first` to `last` the one that is farthest apart.
SpreadAt spread_of(const Rollouts& rollouts, int frame, int first, int last) {
  std::vector<SpreadAt> spreads;
  for (int plate = first; plate <= last; ++plate) {
    spreads.push_back(spread_of_plate(rollouts, frame, plate));
  }
  return *std::ranges::max_element(spreads, {}, &SpreadAt::largest_distance_m);
}

/// Smallest clearance of the motion through the rollout's frames.
double clearance_m(const CollisionChecker& checker, const Eigen::MatrixXf& rollout) {
  double smallest = checker.clearance(shape(rollout, 0)).value_m;
  for (Eigen::Index k = 1; k < rollout.cols(); ++k) {
    smallest = checker.motion_clearance(shape(rollout, k - 1), shape(rollout, k), smallest).value_m;
  }
  return smallest;
}

PlanSpread::Closest closest_approach(const Plan& plan, const Rollouts& rollouts,
                                     const CollisionChecker& checker) {
  PlanSpread::Closest closest;
  const auto planned = mapped<Clearance>(
      plan.frames, [&](const PlanFrame& frame) { return checker.clearance(frame.backbone); });
  const auto nearest = std::ranges::min_element(planned, {}, &Clearance::value_m);
  closest.gap = nearest->gap;
  closest.obstacle = nearest->obstacle;
  closest.at = spread_of(rollouts, int(nearest - planned.begin()), nearest->gap, nearest->gap + 1);
  const auto clearances = mapped<double>(
      rollouts, [&](const Eigen::MatrixXf& rollout) { return clearance_m(checker, rollout); });
  closest.clearance = member_figures(clearances);
  return closest;
}

}  // namespace

std::optional<PlanSpread> plan_spread(const Plan& plan, const ArmDescription& arm,
                                      const CompensationModel& model,
                                      const Environment& environment) {
  if (model.member_count() == 1) {
    return std::nullopt;
  }
  const EnsembleForward ensemble(arm, model);
  const Rollouts rollouts = roll_out(plan, ensemble);
  if (!std::ranges::all_of(rollouts, [](const Eigen::MatrixXf& r) { return r.allFinite(); })) {
    return std::nullopt;
  }
  PlanSpread spread;
  spread.members = ensemble.member_count();
  const int last = plan.frame_count() - 1;
  const auto distances = mapped<double>(rollouts, [&](const Eigen::MatrixXf& rollout) {
    return pose_error(environment.goal, tip_pose(shape(rollout, last))).position_m;
  });
  spread.goal_distance = member_figures(distances);
  spread.end = spread_of(rollouts, last, 0, arm.point_count() - 1);
  if (!environment.obstacles.empty()) {
    spread.closest = closest_approach(plan, rollouts, CollisionChecker(arm, environment.obstacles));
  }
  return spread;
}

}  // namespace limber
