#pragma once

#include <unordered_map>
#include <vector>

#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// Says which motions of a forest an environment is likely to leave free, from the stored shapes
/// alone: no query of the model, some microseconds per edge. Both answers are guesses. All
/// arguments are borrowed.
class ForestFilter {
 public:
  /// @pre the forest was grown for the problem's arm
  ForestFilter(const Forest& forest, const PlanningProblem& problem,
               const CollisionChecker& checker);

  /// Whether nothing is likely to be in the way of the motions from the start to `node`, and of the
  /// hold there.
  bool leaves_free(int node);

 private:
  /// At the end of the motion to it, which is left in after_.
  bool stands_free(int node);
  bool leaves_path_free(int node);
  /// The same of the motion from its parent alone, its end included.
  bool leaves_edge_free(int node);
  /// The same for the hold: the arm follows late, so its tip moves on to where it is held.
  bool leaves_hold_free(int node);
  void blend(int from, int to, float fraction, Backbone& backbone) const;

  const Forest& forest_;
  const CollisionChecker& checker_;
  double arm_length_m_;
  std::unordered_map<int, bool> known_;  // of nodes asked for, and those on the path to them
  std::vector<int> path_;
  Backbone before_;
  Backbone after_;
  Backbone between_;
};

}  // namespace limber
