#include "pressure_tree.hpp"

#include <algorithm>
#include <cassert>

#include "limber/common/mapped.hpp"

namespace limber {

int PressureTree::add(const MotionState& state, int parent, double cost_kpa) {
  return add(state, model_.settled_tip(state.valves, state.backbone), parent, cost_kpa);
}

int PressureTree::add(const MotionState& state, const Pose& settled_tip, int parent,
                      double cost_kpa) {
  assert(state.valves.size() == model_.valves().state_size() &&
         state.backbone.rows() == model_.point_count());
  const int i = size();
  nodes_.push_back({-1, -1, -1, cost_kpa, settled_tip});
  valves_.insert(valves_.end(), state.valves.begin(), state.valves.end());
  backbones_.insert(backbones_.end(), state.backbone.data(),
                    state.backbone.data() + state.backbone.size());
  befores_.insert(befores_.end(), state.before.data(), state.before.data() + state.before.size());
  if (parent >= 0) {
    attach(i, parent);
  }
  return i;
}

Eigen::Map<const Eigen::VectorXf> PressureTree::valves(int i) const {
  const int size = model_.valves().state_size();
  return {valves_.data() + std::ptrdiff_t(i) * size, size};
}

Eigen::Map<const Pressures> PressureTree::setpoint_kpa(int i) const {
  return {valves(i).data() + model_.channel_count(), model_.channel_count()};
}

Eigen::Map<const Backbone> PressureTree::backbone(int i) const {
  const int points = model_.point_count();
  return {backbones_.data() + std::ptrdiff_t(i) * kPoseSize * points, points, kPoseSize};
}

Eigen::Map<const Backbone> PressureTree::before(int i) const {
  const int points = model_.point_count();
  return {befores_.data() + std::ptrdiff_t(i) * kPoseSize * points, points, kPoseSize};
}

MotionState PressureTree::state(int i) const {
  return model_.moving_state(valves(i), backbone(i),
                             model_.reads_velocity() ? before(i) : backbone(i));
}

void PressureTree::attach(int i, int parent) {
  node(i).parent = parent;
  node(i).next_sibling = node(parent).first_child;
  node(parent).first_child = i;
}

void PressureTree::set_parent(int i, int parent) {
  int* link = &node(node(i).parent).first_child;
  while (*link != i) {
    link = &node(*link).next_sibling;
  }
  *link = node(i).next_sibling;
  attach(i, parent);
}

void PressureTree::set_state(int i, const MotionState& state) {
  std::copy(state.valves.begin(), state.valves.end(),
            valves_.begin() + std::ptrdiff_t(i) * state.valves.size());
  std::copy_n(state.backbone.data(), state.backbone.size(),
              backbones_.begin() + std::ptrdiff_t(i) * state.backbone.size());
  std::copy_n(state.before.data(), state.before.size(),
              befores_.begin() + std::ptrdiff_t(i) * state.before.size());
  node(i).settled_tip = model_.settled_tip(state.valves, state.backbone);
}

std::vector<int> PressureTree::nodes_to(int i) const {
  std::vector<int> nodes;
  for (; i >= 0; i = parent(i)) {
    nodes.push_back(i);
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<Pressures> PressureTree::path_to(int i) const {
  return mapped<Pressures>(nodes_to(i),
                           [&](const int node) { return Pressures(setpoint_kpa(node)); });
}

std::size_t PressureTree::bytes_per_node() const {
  return sizeof(Node) +
         sizeof(float) * std::size_t(model_.valves().state_size() +
                                     (model_.reads_velocity() ? 2 * kPoseSize : kPoseSize) *
                                         model_.point_count());
}

}  // namespace limber
