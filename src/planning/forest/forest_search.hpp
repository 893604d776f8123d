#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "limber/planning/forest.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/collision.hpp"
#include "search/batch_search.hpp"
#include "search/path_simulator.hpp"

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

/// Searches a forest for motions that an environment leaves free, and grafts them into a search:
/// those that end in the goal, the cheapest first; if there are none, those that end near it, with
/// a Newton step toward it at their end. Only motions that the filter accepts are simulated, and a
/// motion in collision rules out all that continue from it. All arguments are borrowed.
class ForestSearch {
 public:
  /// @pre the forest was grown for the problem's arm, model and start
  ForestSearch(const Forest& forest, const PlanningProblem& problem,
               const CollisionChecker& checker, PathSimulator& simulator, BatchSearch& search);

  struct Round {
    bool more = false;                         ///< there may be more worth trying
    std::vector<BatchSearch::Solution> found;  ///< that the search now has
  };

  /// Tries a batch of motions. @param has_plan  whether one of those found so far stands
  Round round(const std::function<bool()>& give_up, bool has_plan);

 private:
  /// Nodes, those with the smallest numbers first. A heap, because mostly few of them are needed.
  using Ranked = std::pair<double, int>;
  using Ranking = std::priority_queue<Ranked, std::vector<Ranked>, std::greater<>>;

  /// A motion to try: to a node of the forest, and perhaps one step further.
  struct Candidate {
    int node;
    std::vector<int> path;  // nodes after the last known state on the path, the node included
    std::optional<Pressures> step_kpa;
  };
  struct Batch {
    std::vector<Candidate> candidates;
    std::vector<Path> paths;  // one per candidate
  };

  Ranking those_in_goal() const;
  Ranking those_near() const;
  Batch next_batch(const std::function<bool()>& give_up, bool has_plan);
  /// Of the first of `nodes`, which are taken out, at most `wanted` that may be free. @param step
  /// toward the goal
  Batch collect(Ranking& nodes, std::size_t wanted, bool step,
                const std::function<bool()>& give_up);
  std::optional<Candidate> candidate(int node, bool step);
  Path path_of(const Candidate& candidate) const;
  std::optional<BatchSearch::Solution> settle(const Candidate& tried, const PathOutcome& outcome);
  /// Hands the whole motion to the search. @return the search's node
  int graft(int node);

  const Forest& forest_;
  const PlanningProblem& problem_;
  PathSimulator& simulator_;
  BatchSearch& search_;
  ForestFilter filter_;
  PressureBox setpoints_;        // that the problem allows: a forest is grown within the arm's
  Ranking in_goal_;              // nodes that end there, by cost
  std::optional<Ranking> near_;  // by error; found once they are asked for
  std::size_t near_left_;
  int rounds_ = 0;
  int rounds_since_plan_ = 0;
  std::unordered_map<int, MotionState> known_;  // at nodes that are free; empty: ruled out
  std::unordered_set<int> tried_;
  std::unordered_map<int, int> grafted_;  // node of the forest → node of the search
};

}  // namespace limber
