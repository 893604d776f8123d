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
  bool leaves_path_free(int node);
  /// The same of the motion from its parent alone, its end included.
  bool leaves_edge_free(int node) const;
  /// The same of the hold: the arm has followed late, and its tip goes on to where it is held.
  bool leaves_hold_free(int node) const;
  /// The stored shape at a node, or a fraction of the way between two.
  Backbone shape_at(int node) const { return shape_between(node, node, 0.0F); }
  Backbone shape_between(int from, int to, float fraction) const;

  const Forest& forest_;
  const CollisionChecker& checker_;
  double arm_length_m_;
  Backbone start_;                       // whose base all shapes share
  std::unordered_map<int, bool> known_;  // of nodes asked for, and those on the way there
};

}  // namespace limber
