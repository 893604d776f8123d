#include "limber/planning/pressure_tree.hpp"

#include <algorithm>
#include <cassert>

namespace limber {

int PressureTree::add(const Eigen::Ref<const Pressures>& pressures_kpa,
                      const Eigen::Ref<const Backbone>& backbone, int parent, double cost_kpa) {
  assert(pressures_kpa.size() == segment_count_ && backbone.rows() == point_count_);
  const int i = size();
  nodes_.push_back({-1, -1, -1, cost_kpa});
  pressures_kpa_.insert(pressures_kpa_.end(), pressures_kpa.data(),
                        pressures_kpa.data() + segment_count_);
  backbones_.insert(backbones_.end(), backbone.data(), backbone.data() + 3 * point_count_);
  if (parent >= 0) {
    attach(i, parent);
  }
  return i;
}

Eigen::Map<const Pressures> PressureTree::pressures_kpa(int i) const {
  return {pressures_kpa_.data() + std::ptrdiff_t(i) * segment_count_, segment_count_};
}

Eigen::Map<const Backbone> PressureTree::backbone(int i) const {
  return {backbones_.data() + std::ptrdiff_t(i) * 3 * point_count_, point_count_, 3};
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

void PressureTree::set_backbone(int i, const Eigen::Ref<const Backbone>& backbone) {
  std::copy_n(backbone.data(), 3 * point_count_,
              backbones_.data() + std::ptrdiff_t(i) * 3 * point_count_);
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
  std::vector<Pressures> path;
  for (const int node : nodes_to(i)) {
    path.emplace_back(pressures_kpa(node));
  }
  return path;
}

std::size_t PressureTree::bytes_per_node() const {
  return sizeof(Node) + sizeof(float) * static_cast<std::size_t>(segment_count_ + 3 * point_count_);
}

}  // namespace limber
