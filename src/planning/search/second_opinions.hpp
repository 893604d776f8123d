#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// Decides whether a plan that a search has found holds. Searches ask while they go on, so that
/// they end with a plan that holds. Threads: one caller at a time.
class PlanJudge {
 public:
  enum class Verdict {
    holds,
    refused,
    unfinished,  ///< `give_up` came first
  };

  virtual ~PlanJudge() = default;
  /// @param plan     built from its waypoints; a judge may add its findings to it
  /// @param give_up  called now and then; once it is true the answer is `unfinished`, within
  ///                 milliseconds
  virtual Verdict judge(Plan& plan, const std::function<bool()>& give_up) = 0;
};

/// What an ensemble's other networks say about a plan that was searched with the leading one, or
/// all of its networks about a plan that was searched with their mean. Each
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
