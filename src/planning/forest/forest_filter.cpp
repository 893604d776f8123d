#include "forest_filter.hpp"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr float kLookM =
    0.04F;  // of the path of the plate that moves farthest: one check per this length
constexpr int kMaxLooks = 16;  // along an edge

/// Of the plate that moves farthest.
float travel_m(const Backbone& from, const Backbone& to) {
  return std::sqrt((to.leftCols<2>() - from.leftCols<2>()).rowwise().squaredNorm().maxCoeff());
}

}  // namespace

ForestFilter::ForestFilter(const Forest& forest, const PlanningProblem& problem,
                           const CollisionChecker& checker)
    : forest_(forest),
      checker_(checker),
      arm_length_m_(problem.arm.length_m()),
      before_(start_state(problem.environment, problem.arm).backbone),
      after_(before_),
      between_(before_) {
  known_[0] = true;
}

bool ForestFilter::leaves_free(int node) {
  // The end first: one check rules out most motions, and all that continue from there.
  if (known_.count(node) == 0 && !stands_free(node)) {
    known_[node] = false;
  }
  return leaves_path_free(node) && leaves_hold_free(node);
}

bool ForestFilter::stands_free(int node) {
  blend(node, node, 0.0F, after_);
  return checker_.is_free(after_);
}

bool ForestFilter::leaves_path_free(int node) {
  path_.clear();
  for (int i = node; known_.count(i) == 0; i = forest_.parents[static_cast<std::size_t>(i)]) {
    path_.push_back(i);
  }
  for (auto step = path_.rbegin(); step != path_.rend(); ++step) {
    const int parent = forest_.parents[static_cast<std::size_t>(*step)];
    known_[*step] = known_.at(parent) && leaves_edge_free(*step);
  }
  return known_.at(node);
}

bool ForestFilter::leaves_edge_free(int node) {
  const int parent = forest_.parents[static_cast<std::size_t>(node)];
  if (!stands_free(node)) {
    return false;
  }
  blend(parent, parent, 0.0F, before_);
  const int looks =
      std::min(kMaxLooks, static_cast<int>(std::ceil(travel_m(before_, after_) / kLookM)));
  for (int k = 1; k < looks; ++k) {
    blend(parent, node, static_cast<float>(k) / static_cast<float>(looks), between_);
    if (!checker_.is_free(between_)) {
      return false;
    }
  }
  return true;
}

bool ForestFilter::leaves_hold_free(int node) {
  blend(node, node, 0.0F, between_);
  after_ = between_;
  // Only the tip of the held shape is stored: every plate moves by its share of the tip's motion.
  const Eigen::Index last = after_.rows() - 1;
  const Eigen::RowVector3f shift = forest_.held_tips.col(node).transpose() - after_.row(last);
  for (Eigen::Index plate = 1; plate <= last; ++plate) {
    const float part = static_cast<float>(plate) / static_cast<float>(last);
    after_.row(plate) += part * part * shift;
  }
  return checker_.is_motion_free(between_, after_);
}

void ForestFilter::blend(int from, int to, float fraction, Backbone& backbone) const {
  blend_shapes(forest_.shapes.col(from), forest_.shapes.col(to), fraction, arm_length_m_, backbone);
}

}  // namespace limber
