#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "limber/forward/motion_model.hpp"

namespace limber {

/// Tree of states (set points, pressures, backbone) that grows from one root. The same set points
/// reached along another path are another state. Node 0 is the root. References into the tree are
/// valid until the next `add`.
class PressureTree {
 public:
  explicit PressureTree(const MotionModel& model) : model_(model) {}

  /// @param parent  −1 for the root, which comes first
  /// @param cost_kpa  of the motion from the root
  int add(const MotionState& state, int parent, double cost_kpa);
  /// The same if the caller knows the state's settled tip already.
  int add(const MotionState& state, const Pose& settled_tip, int parent, double cost_kpa);

  int size() const { return int(nodes_.size()); }
  int parent(int i) const { return node(i).parent; }
  double cost_kpa(int i) const { return node(i).cost_kpa; }
  Eigen::Map<const Pressures> setpoint_kpa(int i) const;
  Eigen::Map<const Eigen::VectorXf> valves(int i) const;
  Eigen::Map<const Backbone> backbone(int i) const;
  /// A frame earlier. @pre the model reads velocities
  Eigen::Map<const Backbone> before(int i) const;
  MotionState state(int i) const;
  /// MotionModel::settled_tip of the state: about where the node's set points lead.
  const Pose& settled_tip(int i) const { return node(i).settled_tip; }

  /// Calls visit(child) for the children of i.
  template <class Visit>
  void visit_children(int i, Visit&& visit) const {
    for (int child = node(i).first_child; child >= 0; child = node(child).next_sibling) {
      visit(child);
    }
  }

  /// Moves i, with everything below it, to another parent. @pre `parent` is not below i.
  void set_parent(int i, int parent);
  void set_cost_kpa(int i, double cost_kpa) { node(i).cost_kpa = cost_kpa; }
  /// Another state at the same set points.
  void set_state(int i, const MotionState& state);

  /// The nodes from the root to i, and their set points.
  std::vector<int> nodes_to(int i) const;
  std::vector<Pressures> path_to(int i) const;

  /// Bytes that one more node takes.
  std::size_t bytes_per_node() const;

 private:
  struct Node {
    int parent = -1;
    int first_child = -1;
    int next_sibling = -1;
    double cost_kpa = 0.0;
    Pose settled_tip;
  };

  Node& node(int i) { return nodes_[i]; }
  const Node& node(int i) const { return nodes_[i]; }
  void attach(int i, int parent);

  MotionModel model_;
  std::vector<Node> nodes_;
  std::vector<float> valves_;     // one valve state per node
  std::vector<float> backbones_;  // 3m per node
  std::vector<float> befores_;    // the same, where the model reads velocities
};

}  // namespace limber
