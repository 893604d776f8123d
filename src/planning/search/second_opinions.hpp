#pragma once

#include <memory>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// What an ensemble's other networks say about a plan that was searched with the leading one. Each
/// is wrong in other places: if a search has found an error of the leading network that makes a
/// plan cheap, the others mostly disagree (docs/planning.md, No feeding on errors).
class SecondOpinions {
 public:
  /// With a model of one network, or none, there are no other opinions. Borrows problem and
  /// checker.
  SecondOpinions(const PlanningProblem& problem, const CollisionChecker& checker);

  bool empty() const { return others_.empty(); }
  /// Whether the plan along these waypoints, start first, is free and ends in the goal for all of
  /// them.
  bool agree(const std::vector<Pressures>& waypoints_kpa);
  /// Of the forward models, so far.
  std::uint64_t queries() const;

 private:
  struct Other {
    Other(const PlanningProblem& problem, int member, const CollisionChecker& checker);
    ForwardModel forward;
    MotionSimulator simulator;
  };

  const PlanningProblem& problem_;
  MotionState start_;
  std::vector<std::unique_ptr<Other>> others_;
};

}  // namespace limber
