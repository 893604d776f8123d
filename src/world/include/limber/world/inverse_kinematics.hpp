#pragma once
// For those who plan.

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

class RandomStream;

struct InverseKinematicsSettings {
  int starts = 40;                  ///< random configurations Newton starts from, 1 to 10000
  int max_solutions = 8;            ///< stops early at this many distinct ones, ≥ 1
  int iterations = 60;              ///< Newton steps per start, 1 to 1000
  double convergence_m = 1e-10;     ///< a start is done at this residual, > 0
  double distinct_pressure = 0.01;  ///< solutions differ by more of some segment's largest command
  /// Of each segment, within the model's; empty: the model's.
  std::vector<PressureLimits> limits = {};
  std::function<bool()> give_up = {};  ///< asked between starts; may be empty
};

/// What was found; no solution is an expected outcome.
struct InverseKinematicsResult {
  /// Size n each, gauge, signed, within the limits; their no-load tips lie in the goal's region.
  /// In the order found.
  std::vector<Eigen::VectorXd> pressures_kpa;
  /// The nearest configuration of all starts, and its errors: they say how far the goal is out of
  /// reach if `pressures_kpa` is empty.
  Eigen::VectorXd best_pressures_kpa;
  PoseError best_error;
  int starts_used = 0;
  std::string reason;  ///< why there is no solution, with amounts; empty if there is one

  bool reachable() const { return !pressures_kpa.empty(); }
};

/// Configurations whose no-load tip is at the goal: Newton–Raphson over curvatures from many random
/// starts within the pressure limits, then curvature → strain → pressure (docs/model.md (14)).
///
/// Steps use the damped pseudo-inverse, J⁺ = Jᵀ (J Jᵀ + λI)⁻¹, on two rows for a position and three
/// for a pose; the damping vanishes as the steps succeed. A segment at its limit that the step
/// would push further is held. Steps go straight across κ = 0, where J jumps: the residual is
/// continuous there, and a step counts only if it lowers it.
///
/// Not complete: if no solution is found, there may still be one.
/// Threads: reads the model only; samples from `random`, starts × n numbers at most.
/// @throws InputError if the goal or a setting is not finite or out of range.
[[nodiscard]] InverseKinematicsResult solve_inverse_kinematics(
    const NoLoadModel& model, const PoseGoal& goal, const InverseKinematicsSettings& settings,
    RandomStream& random);

}  // namespace limber
