#include "forest_filter.hpp"

#include <algorithm>
#include <cmath>

#include "limber/arm/plate_distance.hpp"

namespace limber {

namespace {

constexpr double kLookM = 0.04;     // of the plate that moves farthest: one check per this length
constexpr int kMaxEdgeChecks = 16;  // along an edge

}  // namespace

ForestFilter::ForestFilter(const Forest& forest, const PlanningProblem& problem,
                           const CollisionChecker& checker)
    : forest_(forest),
      checker_(checker),
      arm_length_m_(problem.arm.length_m()),
      start_(start_state(problem.environment, problem.arm).backbone) {
  known_[0] = true;
}

bool ForestFilter::leaves_free(int node) {
  // The end first: one look rules out most, and all that goes on from there.
  if (known_.count(node) == 0 && !checker_.is_free(shape_at(node))) {
    known_[node] = false;
  }
  return leaves_path_free(node) && leaves_hold_free(node);
}

bool ForestFilter::leaves_path_free(int node) {
  std::vector<int> path;
  for (int i = node; known_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    path.push_back(i);
  }
  for (auto step = path.rbegin(); step != path.rend(); ++step) {
    const int parent = forest_.parents[static_cast<std::size_t>(*step)];
    known_[*step] = known_.at(parent) && leaves_edge_free(*step);
  }
  return known_.at(node);
}

bool ForestFilter::leaves_edge_free(int node) const {
  const int parent = forest_.parents[static_cast<std::size_t>(node)];
  const Backbone end = shape_at(node);
  if (!checker_.is_free(end)) {
    return false;
  }
  const int looks = std::min(
      kMaxEdgeChecks,
      static_cast<int>(std::ceil(largest_plate_distance_m(shape_at(parent), end) / kLookM)));
  for (int k = 1; k < looks; ++k) {
    if (!checker_.is_free(
            shape_between(parent, node, static_cast<float>(k) / static_cast<float>(looks)))) {
      return false;
    }
  }
  return true;
}

bool ForestFilter::leaves_hold_free(int node) const {
  const Backbone end = shape_at(node);
  Backbone held = end;
  // Of the held shape the tip alone is stored: every plate does its part of what the tip does.
  const Eigen::Index last = held.rows() - 1;
  const Eigen::RowVector3f shift = forest_.held_tips.col(node).transpose() - held.row(last);
  for (Eigen::Index plate = 1; plate <= last; ++plate) {
    const float part = static_cast<float>(plate) / static_cast<float>(last);
    held.row(plate) += part * part * shift;
  }
  return checker_.is_motion_free(end, held);
}

Backbone ForestFilter::shape_between(int from, int to, float fraction) const {
  Backbone shape = start_;
  blend_shapes(forest_.shapes.col(from), forest_.shapes.col(to), fraction, arm_length_m_, shape);
  return shape;
}

}  // namespace limber
