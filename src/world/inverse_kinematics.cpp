#include "limber/world/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "limber/arm/damped_solve.hpp"
#include "limber/arm/jacobian.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr double kMinDamping = 1e-12;   // relative to J Jᵀ; keeps the solve regular
constexpr double kMaxDamping = 1e8;     // no step this short will help: the start has stalled
constexpr double kMinScale = 1e-12;     // [m²]; where every segment is held
constexpr double kStalledStep = 1e-12;  // relative to the curvature limits

// At these the search takes seconds.
constexpr int kMaxStarts = 10'000;
constexpr int kMaxIterations = 1000;

double wrapped(double angle_rad) {
  return std::remainder(angle_rad, 2.0 * std::numbers::pi);
}

/// One Newton descent. Unknowns are curvatures over the largest of either side, z ∈ [−1, 1]ⁿ or in
/// less, where limits are narrower to one side; the rows of the residual are metres, an orientation
/// error being scaled by the arm's length.
class Descent {
 public:
  Descent(const NoLoadModel& model, const PoseGoal& goal, const std::vector<PressureLimits>& limits)
      : model_(model),
        goal_(goal),
        limits_(model.segment_count()),
        low_(SegmentVector::Constant(model.segment_count(), -1.0)),
        high_(SegmentVector::Constant(model.segment_count(), 1.0)) {
    for (int i = 0; i < model.segment_count(); ++i) {
      bound(i, limits.empty() ? model.segment(i).pressure_limit_kpa : limits[i]);
      arm_length_m_ += model.segment(i).length_m;
    }
  }

  /// Where every segment may start: anywhere in its bounds.
  SegmentVector random_start(RandomStream& random) const {
    SegmentVector z(low_.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      z[i] = random.uniform(low_[i], high_[i]);
    }
    return z;
  }

  void start_at(const SegmentVector& z) {
    z_ = z;
    linearise();
    residual_ = residual(tip_);
  }

  /// Goes down until converged, stalled, or out of iterations.
  void run(int iterations, double convergence_m) {
    double damping = 1e-3;
    for (int k = 0; k < iterations && residual_.norm() > convergence_m; ++k) {
      const SegmentVector candidate = (z_ + step(damping)).cwiseMax(low_).cwiseMin(high_);
      const double moved = (candidate - z_).cwiseAbs().maxCoeff();
      const Pose tip = tip_at_curvatures(model_, candidate.cwiseProduct(limits_));
      if (residual(tip).squaredNorm() < residual_.squaredNorm()) {
        start_at(candidate);
        damping = std::max(kMinDamping, damping * 0.1);
      } else {
        damping *= 10.0;
      }
      if (moved < kStalledStep || damping > kMaxDamping) {
        break;
      }
    }
  }

  SegmentVector curvatures() const { return z_.cwiseProduct(limits_); }
  PoseError error() const { return pose_error(goal_, tip_); }

 private:
  void bound(int i, const PressureLimits& limits) {
    const double ends[] = {model_.segment_shape(i, limits.lower_kpa).curvature_per_m,
                           model_.segment_shape(i, limits.upper_kpa).curvature_per_m};
    limits_[i] = std::max(std::abs(ends[0]), std::abs(ends[1]));
    if (limits_[i] > 0.0) {
      low_[i] = std::min(ends[0], ends[1]) / limits_[i];
      high_[i] = std::max(ends[0], ends[1]) / limits_[i];
    }
  }

  void linearise() {
    tip_jacobian(model_, z_.cwiseProduct(limits_), jacobian_, tip_);
    jacobian_ *= limits_.asDiagonal();
    jacobian_.row(2) *= goal_.theta_rad ? arm_length_m_ : 0.0;
  }

  Eigen::Vector3d residual(const Pose& tip) const {
    const double turn = goal_.theta_rad ? wrapped(*goal_.theta_rad - tip.theta_rad) : 0.0;
    return {goal_.x_m - tip.x_m, goal_.y_m - tip.y_m, turn * arm_length_m_};
  }

  /// Damped pseudo-inverse step; segments that it would push past their limit are held instead.
  SegmentVector step(double damping) const {
    PlanarJacobian free = jacobian_;
    while (true) {  // ends after n holds at the latest
      Eigen::Matrix3d normal = free * free.transpose();
      const double scale = std::max(normal.trace(), kMinScale);
      if (!goal_.theta_rad) {
        normal(2, 2) = scale;  // an unused row: its residual is zero
      }
      SegmentVector step = free.transpose() * damped_solve(normal, residual_, damping * scale);
      bool held = false;
      for (int i = 0; i < step.size(); ++i) {
        if ((z_[i] >= high_[i] && step[i] > 0.0) || (z_[i] <= low_[i] && step[i] < 0.0)) {
          free.col(i).setZero();
          held = true;
        }
      }
      if (!held) {
        return step;
      }
    }
  }

  const NoLoadModel& model_;
  const PoseGoal& goal_;
  SegmentVector limits_;
  SegmentVector low_;
  SegmentVector high_;
  double arm_length_m_ = 0.0;
  SegmentVector z_;
  PlanarJacobian jacobian_;
  Pose tip_;
  Eigen::Vector3d residual_;
};

/// Curvature → strain → pressure, segment by segment.
Eigen::VectorXd pressures_at(const NoLoadModel& model, const SegmentVector& curvatures,
                             const std::vector<PressureLimits>& limits) {
  Eigen::VectorXd pressures(curvatures.size());
  for (int i = 0; i < model.segment_count(); ++i) {
    pressures[i] = model.pressure_for_curvature(i, curvatures[i]).pressure_kpa;
    if (!limits.empty()) {
      pressures[i] = limits[i].clamped(pressures[i]);
    }
  }
  return pressures;
}

/// Distance from the region itself [m], a turn weighed by the arm's length; orders the failures.
double excess(const PoseGoal& goal, const PoseError& error, double arm_length_m) {
  return std::max(0.0, error.position_m - goal.position_tolerance_m) +
         std::max(0.0, error.orientation_rad - goal.orientation_tolerance_rad) * arm_length_m;
}

void require_valid(const NoLoadModel& model, const PoseGoal& goal,
                   const InverseKinematicsSettings& settings) {
  const bool finite = std::isfinite(goal.x_m) && std::isfinite(goal.y_m) &&
                      (!goal.theta_rad || std::isfinite(*goal.theta_rad));
  if (!finite) {
    throw InputError(fmt::format("goal ({}, {}, {}); expected finite metres and radians", goal.x_m,
                                 goal.y_m, goal.theta_rad.value_or(0.0)));
  }
  refuse_if(!(goal.position_tolerance_m > 0.0) || !(goal.orientation_tolerance_rad > 0.0),
            "goal tolerances {} m and {} rad; expected both > 0", goal.position_tolerance_m,
            goal.orientation_tolerance_rad);
  refuse_if(!settings.limits.empty() && std::ssize(settings.limits) != model.segment_count(),
            "inverse kinematics: {} limits; the arm has {} segments", settings.limits.size(),
            model.segment_count());
  refuse_if(
      settings.starts < 1 || settings.starts > kMaxStarts || settings.max_solutions < 1 ||
          settings.iterations < 1 || settings.iterations > kMaxIterations ||
          !(settings.convergence_m > 0.0) || !(settings.distinct_pressure >= 0.0),
      "inverse kinematics: {} starts, {} solutions, {} iterations, convergence of {} m, distinct "
      "by {} of the largest command; all must be positive, at most {} starts and {} iterations",
      settings.starts, settings.max_solutions, settings.iterations, settings.convergence_m,
      settings.distinct_pressure, kMaxStarts, kMaxIterations);
}

std::string describe_failure(const PoseGoal& goal, const InverseKinematicsResult& result,
                             double arm_length_m) {
  std::string text = fmt::format(
      "the nearest of {} starts ends {:.1f} cm from the goal (tolerance {:.1f} cm)",
      result.starts_used, result.best_error.position_m * 100.0, goal.position_tolerance_m * 100.0);
  if (goal.theta_rad) {
    text += fmt::format(" and {:.2f} rad off (tolerance {:.2f} rad)",
                        result.best_error.orientation_rad, goal.orientation_tolerance_rad);
  }
  const double distance = std::hypot(goal.x_m, goal.y_m);
  if (distance > arm_length_m + goal.position_tolerance_m) {
    text += fmt::format("; it is {:.1f} cm from the base, the arm is {:.1f} cm long",
                        distance * 100.0, arm_length_m * 100.0);
  }
  return text;
}

}  // namespace

InverseKinematicsResult solve_inverse_kinematics(const NoLoadModel& model, const PoseGoal& goal,
                                                 const InverseKinematicsSettings& settings,
                                                 RandomStream& random) {
  require_valid(model, goal, settings);
  const int n = model.segment_count();
  double arm_length_m = 0.0;
  Eigen::VectorXd distinct_kpa(n);
  for (int i = 0; i < n; ++i) {
    arm_length_m += model.segment(i).length_m;
    distinct_kpa[i] =
        settings.distinct_pressure * model.segment(i).pressure_limit_kpa.largest_kpa();
  }
  InverseKinematicsResult result;
  double min_excess = std::numeric_limits<double>::infinity();
  Descent descent(model, goal, settings.limits);
  while (result.starts_used < settings.starts &&
         int(result.pressures_kpa.size()) < settings.max_solutions &&
         !(result.starts_used > 0 && settings.give_up && settings.give_up())) {
    ++result.starts_used;
    descent.start_at(descent.random_start(random));
    descent.run(settings.iterations, settings.convergence_m);
    const Eigen::VectorXd pressures = pressures_at(model, descent.curvatures(), settings.limits);
    const PoseError error = descent.error();
    const double score = excess(goal, error, arm_length_m);
    if (score < min_excess ||
        (score == min_excess && error.position_m < result.best_error.position_m)) {
      min_excess = score;
      result.best_error = error;
      result.best_pressures_kpa = pressures;
    }
    const auto is_same = [&](const Eigen::VectorXd& other) {
      return ((other - pressures).cwiseAbs().array() <= distinct_kpa.array()).all();
    };
    if (is_within(goal, error) &&
        std::none_of(result.pressures_kpa.begin(), result.pressures_kpa.end(), is_same)) {
      result.pressures_kpa.push_back(pressures);
    }
  }
  if (!result.reachable()) {
    result.reason = describe_failure(goal, result, arm_length_m);
  }
  return result;
}

}  // namespace limber
