#include "sparse_tree.hpp"

#include <cmath>
#include <limits>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace limber {

namespace {

// Nodes of which the nearest becomes a parent; powers of two up to this are equally likely, so that
// edges of all lengths are tried: one that overshoots has to come back from far away.
constexpr int kMaxParentChoices = 32;

/// A hash of all that `hash` is of, and `value`.
std::uint64_t mixed(std::uint64_t hash, std::int64_t value) {
  return XXH3_64bits_withSeed(&value, sizeof value, hash);
}

}  // namespace

int random_power_of_two(RandomStream& random, int most) {
  int kinds = 1;
  while (1 << (kinds - 1) < most) {
    ++kinds;
  }
  return 1 << random.index(std::uint32_t(kinds));
}

SparseTree::SparseTree(const ArmDescription& arm, const MotionModel& model, const StateCells& cells,
                       const MotionState& root)
    : model_(model),
      cells_(cells),
      scale_kpa_(pressure_scales_kpa(arm)),
      box_(pressure_box(arm)),
      tree_(model),
      index_(arm.channel_count()) {
  add(root, -1, 0.0);
}

std::optional<int> SparseTree::add(const MotionState& state, int parent, double cost_kpa,
                                   bool always) {
  const Pose tip = model_.settled_tip(state.valves, state.backbone);
  const auto [entry, is_new] = cheapest_.try_emplace(cell_of(state, tip), tree_.size());
  const bool is_cheaper = !is_new && cost_kpa < tree_.cost_kpa(entry->second);
  if (!is_new && !is_cheaper && !always) {
    return std::nullopt;
  }
  const int node = tree_.add(state, tip, parent, cost_kpa);
  index_.add(scaled(state.setpoint_kpa()));
  stands_for_.push_back(node);
  if (is_cheaper) {
    stands_for_[entry->second] = node;
    entry->second = node;
  }
  return node;
}

int SparseTree::random_node(RandomStream& random) const {
  return int(random.index(std::uint32_t(tree_.size())));
}

int SparseTree::parent_near(const Pressures& target_kpa, double random_share,
                            RandomStream& random) const {
  int node = 0;
  if (random.uniform() >= random_share) {
    node = index_.nearest(scaled(target_kpa));
  } else {
    float nearest = std::numeric_limits<float>::infinity();
    const int choices = random_power_of_two(random, kMaxParentChoices);
    for (int k = 0; k < choices; ++k) {
      const int other = random_node(random);
      const float distance =
          (target_kpa - tree_.setpoint_kpa(other)).cwiseQuotient(scale_kpa_).squaredNorm();
      if (distance < nearest) {
        nearest = distance;
        node = other;
      }
    }
  }
  while (stands_for_[node] != node) {
    node = stands_for_[node];
  }
  return node;
}

Pressures SparseTree::stepped(int node, const Pressures& target_kpa, double step) const {
  const auto from = tree_.setpoint_kpa(node);
  const float distance = scaled(target_kpa - from).norm();
  if (distance <= float(step)) {
    return target_kpa;
  }
  return box_.limited(from + (target_kpa - from) * (float(step) / distance));
}

std::uint64_t SparseTree::cell_of(const MotionState& state, const Pose& settled_tip) const {
  const auto quantised = [](double value, double cell) {
    return std::int64_t(std::floor(value / cell));
  };
  std::uint64_t hash = 0;
  // Behind ideal valves the second half says what the first has said.
  const Eigen::Index numbers = (model_.valves().is_ideal() ? 1 : 2) * scale_kpa_.size();
  for (Eigen::Index i = 0; i < numbers; ++i) {
    hash =
        mixed(hash, quantised(double(state.valves[i]) / double(scale_kpa_[i % scale_kpa_.size()]),
                              cells_.pressure));
  }
  hash = mixed(hash, quantised(settled_tip.x_m, cells_.position_m));
  hash = mixed(hash, quantised(settled_tip.y_m, cells_.position_m));
  return mixed(hash, quantised(settled_tip.theta_rad, cells_.orientation_rad));
}

double SparseTree::bytes() const {
  const std::size_t index_bytes = std::size_t(scale_kpa_.size()) * sizeof(float) + 3 * sizeof(int);
  constexpr std::size_t kCellBytes = 48;
  return double(tree_.size()) * double(tree_.bytes_per_node() + index_bytes + kCellBytes);
}

}  // namespace limber
