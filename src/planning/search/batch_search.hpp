#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "default_planner.hpp"
#include "goal_seeker.hpp"
#include "path_simulator.hpp"
#include "sparse_tree.hpp"

namespace limber {

/// Grows a sparse tree by batches of edges, some of them toward the goal. All arguments are
/// borrowed. The tree depends only on the seed, the number of rounds and what is grafted.
class BatchSearch {
 public:
  struct Solution {
    int node;
    double cost_kpa;
    Pose held_tip;  ///< after the hold
  };

  /// @param first_proposal  number of its first edge among those of the seed
  BatchSearch(const PlanningProblem& problem, PathSimulator& simulator,
              const DefaultPlannerSettings& settings, std::uint64_t seed,
              std::uint64_t first_proposal = 0);

  /// Proposes a batch of edges, simulates them, adds what is free and new.
  /// @param best_cost_kpa  of any plan known: edges that cost more than some multiple are not tried
  /// @return the new nodes in the goal, in the order found
  std::vector<Solution> round(const std::optional<double>& best_cost_kpa,
                              const std::function<bool()>& give_up);

  /// Adds a state that other code has reached from `parent`, free of collision.
  /// @return its node
  int graft(int parent, const MotionState& state);
  Solution solution_at(int node, const Pose& held_tip) const;

  Pressures limited(const Pressures& pressures_kpa) const {
    return tree_.box().limited(pressures_kpa);
  }

  std::vector<Pressures> waypoints_to(int node) const { return tree().path_to(node); }
  /// The node whose tip settles nearest to the goal.
  int nearest_node() const { return elite_.front().node; }
  /// How near that is, in the goal's tolerances.
  double nearest_error() const { return elite_.front().error; }

  const PressureTree& tree() const { return tree_.states(); }
  double bytes() const { return tree_.bytes(); }
  /// Edges of the seed proposed so far, simulated or not.
  std::uint64_t proposals() const { return proposals_; }

 private:
  struct Edge {
    int parent;
    Pressures to_kpa;
    double cost_kpa = 0.0;  // from the root; of those worth simulating
  };
  struct Elite {
    double error;
    int node;
  };

  std::vector<Edge> propose_batch(const std::optional<double>& best_cost_kpa);
  Edge propose(RandomStream& random);
  Edge shot_at_goal(RandomStream& random);
  Edge exploration(RandomStream& random);
  Pressures scattered(const Pressures& about_kpa, double spread, RandomStream& random) const;
  double error_of(int node) const;
  /// @return where the edge ends, if that is new and in the goal
  std::optional<Solution> add(const Edge& edge, const PathOutcome& outcome);
  void note_error(int node);

  const PlanningProblem& problem_;
  PathSimulator& simulator_;
  DefaultPlannerSettings settings_;
  std::uint64_t seed_;
  GoalSampler goal_sampler_;
  SparseTree tree_;
  std::vector<Elite> elite_;  // nearest to the goal first
  int rounds_ = 0;
  std::uint64_t proposals_;
};

}  // namespace limber
