#pragma once

#include <vector>

#include <Eigen/Core>

namespace limber {

/// Nearest neighbours among configurations, by Euclidean distance: a k-d tree with leaves of up to
/// kLeafSize points that split when full. Points are only added. Ties go to the point added first,
/// so that answers do not depend on the tree's shape. Threads: one writer or many readers.
class PressureIndex {
 public:
  explicit PressureIndex(int dimension);

  /// Adds a point; its number is the count of points before. @param point size `dimension`, finite
  void add(const Eigen::Ref<const Eigen::VectorXf>& point);

  /// Number of the nearest point, −1 if there is none.
  int nearest(const Eigen::Ref<const Eigen::VectorXf>& query) const;

  /// Numbers of all points within `radius` (closed), ascending, written to `found`.
  void within(const Eigen::Ref<const Eigen::VectorXf>& query, float radius,
              std::vector<int>& found) const;

  int size() const { return int(points_.size()) / dimension_; }

 private:
  static constexpr std::size_t kLeafSize = 32;

  struct Cell {
    int axis = -1;  // −1: a leaf
    float split = 0.0F;
    int low = -1;
    int high = -1;
    std::vector<int> members;  // of a leaf
  };

  const float* point(int i) const {
    return points_.data() + std::size_t(i) * std::size_t(dimension_);
  }
  float squared_distance(int i, const float* query) const;
  void split(std::size_t cell);
  void nearest_in(int cell, const float* query, int& best, float& best_squared) const;
  void within_in(int cell, const float* query, float squared, float radius,
                 std::vector<int>& found) const;

  int dimension_;
  std::vector<float> points_;
  std::vector<Cell> cells_;
};

}  // namespace limber
