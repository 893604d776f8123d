#pragma once

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "goal_seeker.hpp"
#include "limber/planning/default_planner.hpp"
#include "limber/planning/pressure_index.hpp"
#include "limber/planning/pressure_tree.hpp"
#include "path_simulator.hpp"

namespace limber {

/// A tree over states (q, B) that grows by batches of edges. Of states alike in pressures and tip
/// the cheapest is kept; states with the same pressures and another tip live side by side, since
/// friction may make the dearer one the only way to the goal (overshoot and return). Everything
/// given is borrowed. The tree depends on the seed and the number of rounds alone.
class BatchSearch {
 public:
  struct Solution {
    int node;
    double cost_kpa;
  };

  BatchSearch(const PlanningProblem& problem, PathSimulator& simulator,
              const DefaultPlannerSettings& settings, std::uint64_t seed);

  /// Proposes a batch of edges, simulates them, adds what is free and new.
  /// @param best_cost_kpa  of any plan known: edges dearer than some multiple are not tried
  void round(const std::optional<double>& best_cost_kpa, const std::function<bool()>& give_up);

  /// Nodes in the goal, in the order found.
  const std::vector<Solution>& solutions() const { return solutions_; }
  std::vector<Pressures> waypoints_to(int node) const { return tree_.path_to(node); }
  /// The node whose tip is nearest to the goal.
  int nearest_node() const { return elite_.front().node; }

  const PressureTree& tree() const { return tree_; }
  double bytes() const;
  /// Edges thought of, simulated or not.
  std::uint64_t proposals() const { return proposals_; }

 private:
  struct Proposal {
    int parent;
    Pressures to_kpa;
  };
  struct Elite {
    double error;
    int node;
  };

  Eigen::VectorXf scaled(const PressuresRef& pressures_kpa) const;
  Pressures limited(const Pressures& pressures_kpa) const;
  Proposal propose(RandomStream& random);
  Proposal shot_at_goal(RandomStream& random);
  Proposal toward_goal_configuration(RandomStream& random);
  Proposal exploration(RandomStream& random);
  int any_node(RandomStream& random) const;
  int parent_near(const Pressures& target_kpa, RandomStream& random) const;
  std::uint64_t cell_of(const PressuresRef& pressures_kpa, const Pose& tip) const;
  void add(const Proposal& edge, double cost_kpa, const PathOutcome& outcome);
  void note_error(int node);

  const PlanningProblem& problem_;
  PathSimulator& simulator_;
  DefaultPlannerSettings settings_;
  std::uint64_t seed_;
  GoalSampler goal_sampler_;
  Pressures limit_kpa_;
  PressureTree tree_;
  PressureIndex index_;
  std::vector<int> stands_for_;  // a node that a cheaper one like it has replaced names that one
  std::unordered_map<std::uint64_t, int> cheapest_;  // node of a cell
  std::vector<Elite> elite_;                         // nearest to the goal first
  std::vector<Solution> solutions_;
  int rounds_ = 0;
  std::uint64_t proposals_ = 0;
  std::vector<Proposal> batch_;
  std::vector<double> costs_kpa_;
  std::vector<Path> paths_;
  std::vector<PathOutcome> outcomes_;
};

}  // namespace limber
