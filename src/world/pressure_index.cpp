#include "limber/world/pressure_index.hpp"

#include <algorithm>
#include <limits>

#include "limber/common/mapped.hpp"

namespace limber {

PressureIndex::PressureIndex(int dimension) : dimension_(dimension), cells_(1) {}

float PressureIndex::squared_distance(int i, const float* query) const {
  const float* p = point(i);
  return sum_of<float>(dimension_, [&](int k) { return (p[k] - query[k]) * (p[k] - query[k]); });
}

void PressureIndex::add(const Eigen::Ref<const Eigen::VectorXf>& new_point) {
  const int number = size();
  points_.insert(points_.end(), new_point.data(), new_point.data() + dimension_);
  std::size_t cell = 0;
  while (cells_[cell].axis >= 0) {
    const Cell& c = cells_[cell];
    cell = std::size_t(new_point[c.axis] < c.split ? c.low : c.high);
  }
  cells_[cell].members.push_back(number);
  if (cells_[cell].members.size() > kLeafSize) {
    split(cell);
  }
}

/// Halves a leaf across its longest side; one whose points all coincide stays whole.
void PressureIndex::split(std::size_t cell) {
  std::vector<int> members = cells_[cell].members;
  int axis = -1;
  float longest = 0.0F;
  for (int k = 0; k < dimension_; ++k) {
    const auto [low, high] = std::minmax_element(
        members.begin(), members.end(), [&](int a, int b) { return point(a)[k] < point(b)[k]; });
    const float side = point(*high)[k] - point(*low)[k];
    if (side > longest) {
      longest = side;
      axis = k;
    }
  }
  if (axis < 0) {
    return;
  }
  const auto middle = members.begin() + std::ptrdiff_t(members.size() / 2);
  std::nth_element(members.begin(), middle, members.end(),
                   [&](int a, int b) { return point(a)[axis] < point(b)[axis]; });
  float value = point(*middle)[axis];
  if (std::none_of(members.begin(), members.end(), [&](int i) { return point(i)[axis] < value; })) {
    // Many points share the smallest value: cut above them instead.
    float above = std::numeric_limits<float>::max();
    for (const int i : members) {
      above = point(i)[axis] > value ? std::min(above, point(i)[axis]) : above;
    }
    value = above;
  }
  const int first = int(cells_.size());
  cells_.resize(cells_.size() + 2);
  for (const int i : members) {
    const int side = point(i)[axis] < value ? 0 : 1;
    cells_[first + side].members.push_back(i);
  }
  cells_[cell] = {axis, value, first, first + 1, {}};
}

void PressureIndex::nearest_in(int cell, const float* query, int& best, float& best_squared) const {
  const Cell& c = cells_[cell];
  if (c.axis < 0) {
    for (const int i : c.members) {
      const float squared = squared_distance(i, query);
      if (squared < best_squared || (squared == best_squared && i < best)) {
        best = i;
        best_squared = squared;
      }
    }
    return;
  }
  const float beyond = query[c.axis] - c.split;
  nearest_in(beyond < 0.0F ? c.low : c.high, query, best, best_squared);
  if (beyond * beyond <= best_squared) {
    nearest_in(beyond < 0.0F ? c.high : c.low, query, best, best_squared);
  }
}

int PressureIndex::nearest(const Eigen::Ref<const Eigen::VectorXf>& query) const {
  int best = -1;
  float best_squared = std::numeric_limits<float>::max();
  nearest_in(0, query.data(), best, best_squared);
  return best;
}

void PressureIndex::within_in(int cell, const float* query, float squared, float radius,
                              std::vector<int>& found) const {
  const Cell& c = cells_[cell];
  if (c.axis < 0) {
    for (const int i : c.members) {
      if (squared_distance(i, query) <= squared) {
        found.push_back(i);
      }
    }
    return;
  }
  const float beyond = query[c.axis] - c.split;
  if (beyond <= radius) {
    within_in(c.low, query, squared, radius, found);
  }
  if (beyond >= -radius) {
    within_in(c.high, query, squared, radius, found);
  }
}

void PressureIndex::within(const Eigen::Ref<const Eigen::VectorXf>& query, float radius,
                           std::vector<int>& found) const {
  found.clear();
  within_in(0, query.data(), radius * radius, radius, found);
  std::sort(found.begin(), found.end());
}

}  // namespace limber
