#pragma once

#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/pose_goal.hpp"

namespace limber {

/// A motion along waypoints as the simulator has it that knows nothing of batches: one frame after
/// another, each checked for collision, and the hold at its end.
struct Walk {
  bool is_free = false;
  std::vector<MotionState> states;  ///< at the waypoints; ends where a motion collides
  Pose held_tip;                    ///< where it is free, the hold included
};

inline Walk walk(const PlanningProblem& problem, const CollisionChecker& checker,
                 const std::vector<Pressures>& waypoints_kpa) {
  MotionSimulator simulator(problem.arm, problem.model, checker);
  Walk result;
  result.states.push_back(start_of(problem));
  for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
    MotionState end;
    if (!simulator.move(result.states.back(), waypoints_kpa[i], end)) {
      return result;
    }
    result.states.push_back(end);
  }
  MotionState held;
  result.is_free = simulator.hold(result.states.back(), held);
  result.held_tip = tip_pose(held.backbone);
  return result;
}

inline bool ends_in_goal(const PlanningProblem& problem, const Walk& walk) {
  const PoseGoal& goal = problem.environment.goal;
  return walk.is_free && is_within(goal, pose_error(goal, walk.held_tip));
}

}  // namespace limber
