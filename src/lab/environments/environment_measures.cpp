#include "limber/lab/environment_measures.hpp"

#include <algorithm>
#include <optional>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kMeasureStream = 0x6d656173ULL;

/// Moves straight to `to_kpa` and holds; none if that collides.
std::optional<Backbone> end_of_straight_line(const PlanningProblem& problem,
                                             MotionSimulator& simulator, const Pressures& to_kpa) {
  MotionState there;
  MotionState held;
  if (!simulator.move(start_of(problem), to_kpa, there) || !simulator.hold(there, held)) {
    return std::nullopt;
  }
  return held.backbone;
}

}  // namespace

bool straight_line_collides(const PlanningProblem& problem, const Pressures& to_kpa) {
  const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
  MotionSimulator simulator(problem.arm, problem.model, checker);
  return !end_of_straight_line(problem, simulator, to_kpa);
}

bool straight_line_solves(const PlanningProblem& problem, const std::vector<Pressures>& to_kpa,
                          int starts, std::uint64_t seed) {
  const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
  MotionSimulator simulator(problem.arm, problem.model, checker);
  RandomStream random(seed, kMeasureStream);
  InverseKinematicsSettings settings;
  settings.starts = starts;
  settings.max_solutions = starts;
  std::vector<Pressures> candidates = to_kpa;
  for (const Eigen::VectorXd& q :
       solve_inverse_kinematics(problem.model.no_load(), problem.environment.goal, settings, random)
           .pressures_kpa) {
    candidates.emplace_back(q.cast<float>());
  }
  return std::any_of(candidates.begin(), candidates.end(), [&](const Pressures& q) {
    const std::optional<Backbone> end = end_of_straight_line(problem, simulator, q);
    const PoseGoal& goal = problem.environment.goal;
    return end && is_within(goal, pose_error(goal, tip_pose(*end)));
  });
}

}  // namespace limber
