#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/pressure_index.hpp"
#include "pressure_tree.hpp"

namespace limber {

/// What makes two states alike: the same cell of set points, of pressures (both as fractions of
/// their limits), and of the position and heading that the tip settles at.
struct StateCells {
  double pressure;
  double position_m;
  double orientation_rad;
};

/// A tree over states that keeps the cheapest state of each kind. States with the same set points
/// and another tip are kept side by side, since friction may make the more expensive one the only
/// path to the goal (overshoot and return). Threads: one writer, or many readers.
class SparseTree {
 public:
  SparseTree(const ArmDescription& arm, const MotionModel& model, const StateCells& cells,
             const MotionState& root);

  /// The new node; none if a similar state is there already and costs no more.
  /// @param always  adds it in any case
  std::optional<int> add(const MotionState& state, int parent, double cost_kpa,
                         bool always = false);

  const PressureTree& states() const { return tree_; }
  int size() const { return tree_.size(); }
  double bytes() const;

  int random_node(RandomStream& random) const;
  /// The node nearest to `target_kpa`, or the nearest of some, so that each of several backbones at
  /// similar pressures gets its turn.
  /// @param random_share  of the calls that ask only some nodes, in [0, 1]
  int parent_near(const Pressures& target_kpa, double random_share, RandomStream& random) const;

  /// From now on configurations are sampled in this box, and limited to it; at first it is that of
  /// the arm's limits.
  void keep_within(const PressureBox& box) { box_ = box; }

  const PressureBox& box() const { return box_; }
  /// `target_kpa`, or the point at distance `step` from the node toward it, if that is nearer.
  Pressures stepped(int node, const Pressures& target_kpa, double step) const;
  /// Fractions of the limits.
  Eigen::VectorXf scaled(const PressuresRef& pressures_kpa) const {
    return pressures_kpa.cwiseQuotient(scale_kpa_);
  }
  const Pressures& scales_kpa() const { return scale_kpa_; }

 private:
  std::uint64_t cell_of(const MotionState& state, const Pose& settled_tip) const;

  MotionModel model_;
  StateCells cells_;
  Pressures scale_kpa_;
  PressureBox box_;
  PressureTree tree_;
  PressureIndex index_;
  std::vector<int> stands_for_;  // a node that a cheaper one like it has replaced names that one
  std::unordered_map<std::uint64_t, int> cheapest_;  // node of a cell
};

/// 1, 2, 4, … `most`, a power of two, each equally likely: the number of nodes of which the best is
/// taken.
int random_power_of_two(RandomStream& random, int most);

}  // namespace limber
