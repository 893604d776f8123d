#pragma once

#include <optional>
#include <vector>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/world/pressure_index.hpp"
#include "planner_budget.hpp"
#include "pressure_tree.hpp"
#include "search/goal_seeker.hpp"

namespace limber {

/// What the paper leaves open about its planner, with our choices (docs/planning.md says why).
/// Distances in pressure are Euclidean, each pressure as a fraction of its segment's limit.
struct PressureRrtStarSettings {
  double step_size = 0.5;  ///< longest edge, > 0
  double near_factor = 1.0;  ///< × the smallest radius that RRT* allows, ≥ 1; at most the step size
  double goal_bias = 0.2;         ///< share of samples at inverse-kinematics solutions, in [0, 1]
  double goal_spread = 0.1;       ///< standard deviation about such a solution: it is approximate
  int goal_configurations = 200;  ///< solutions sampled before they are used again, ≥ 1
  /// Of the largest limit: a rewired node's set points are the same, its pressures agree so,
  double match_pressure = 0.01;
  double match_position_m = 0.005;  ///< and its backbone agrees at every plate
  double match_orientation_rad = 0.05;
  HoldRange hold;  ///< nodes whose tip is this near the goal are held and judged
};

/// The tree of pressure-space RRT*, grown iteration by iteration. All arguments are borrowed.
class RrtStarSearch {
 public:
  RrtStarSearch(const PlanningProblem& problem, MotionSimulator& simulator,
                const PressureRrtStarSettings& settings, std::uint64_t seed);

  /// One sample: at most one new node, and the rewiring about it.
  void iterate(const PlannerBudget& budget);

  /// Waypoints of the cheapest solution so far; empty before the first.
  const std::vector<Pressures>& best_waypoints_kpa() const { return best_waypoints_kpa_; }
  std::optional<double> best_cost_kpa() const { return best_cost_kpa_; }
  /// Waypoints to the node whose tip is nearest to the goal.
  std::vector<Pressures> nearest_waypoints_kpa() const { return tree_.path_to(nearest_node_); }

  const PressureTree& tree() const { return tree_; }
  double bytes() const;
  /// Iterations, nodes and rewires; the rest is left out.
  PlannerStatistics statistics() const;

 private:
  struct Candidate {
    double cost_kpa;
    int node;
  };
  using Nodes = std::vector<int>;
  /// A node below a rewired one, simulated again.
  struct Changed {
    int node;
    double cost_kpa;
    std::optional<MotionState> state;  // none: as before
  };

  Eigen::VectorXf scaled(const PressuresRef& pressures_kpa) const;
  Pressures sample();
  /// None where the sample falls on a node.
  std::optional<Pressures> steer(const Pressures& sample, int nearest) const;
  /// Nodes from which a motion to `kpa` is tried, ascending; the nearest is among them.
  Nodes near(const Pressures& kpa, int nearest) const;
  /// The new node at `kpa`; none where no motion from a near node is free.
  std::optional<int> connect(const Pressures& kpa, const Nodes& near);
  std::vector<Candidate> by_cost(const Pressures& kpa, const Nodes& near) const;
  /// Simulates from one node to all of these at once.
  void simulate_to(const Nodes& nodes, int from);
  void rewire(int from, const Nodes& near, const PlannerBudget& budget);
  void accept_rewiring(const std::vector<Changed>& changed, int from);
  /// What comes of `changed` and of all below it, simulated again; none where that collides.
  std::optional<std::vector<Changed>> simulate_below(Changed changed, const PlannerBudget& budget);
  /// Whether `end` may stand for what the tree has at `node`: the same set points, pressures and
  /// backbone, within the settings.
  bool matches(const MotionState& end, int node) const;
  void judge(int node);
  bool ends_in_goal(int node);
  void consider_best(int node);

  const PlanningProblem& problem_;
  MotionSimulator& simulator_;
  PressureRrtStarSettings settings_;
  RandomStream random_;
  GoalSampler goal_sampler_;
  Pressures scale_kpa_;  // distances are measured in it
  PressureBox box_;
  float match_kpa_;  // between pressures of a node and of what may stand for it
  double near_gain_;

  PressureTree tree_;
  PressureIndex index_;
  std::vector<char> in_goal_;  // one per node
  std::optional<double> best_cost_kpa_;
  std::vector<Pressures> best_waypoints_kpa_;
  int nearest_node_ = 0;
  double nearest_error_ = 0.0;
  PlannerStatistics statistics_;
  MotionBatch batch_;
};

}  // namespace limber
