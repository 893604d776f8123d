#pragma once
// For those who plan.

#include <vector>

#include <Eigen/Core>

#include "limber/world/environment.hpp"

namespace limber {

/// Axis-aligned box.
struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();

  static Box around(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  void include(const Eigen::Vector2d& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

/// Squared distance between two boxes, 0 if they touch.
double squared_distance(const Box& a, const Box& b);

/// An obstacle prepared for distance queries: a circle, or a simple polygon (rectangles too).
struct ObstacleShape {
  int index = -1;                                    ///< in the environment's list
  std::vector<Eigen::Vector2d> vertices;             ///< empty for a circle
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< circle only
  double radius_m = 0.0;                             ///< circle only
  Box box;
  /// Boxes around kEdgesPerBox edges each, beginning with the edge that ends in vertices[0]. What
  /// is far from a box is far from its edges.
  std::vector<Box> edge_boxes;
  double base_distance_m = 0.0;  ///< from the origin of B; 0 if it lies inside

  bool is_circle() const { return vertices.empty(); }

  static constexpr std::size_t kEdgesPerBox = 16;
};

ObstacleShape make_obstacle_shape(const Obstacle& obstacle, int index);

/// Distance from p to the closed segment a–b, squared.
double squared_distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b);

/// Distance from a point to the obstacle's outline, negative inside. Exact.
double signed_distance(const ObstacleShape& shape, const Eigen::Vector2d& p);

/// Distance between the closed segment a–b and the obstacle, 0 if they share a point. Exact.
double outside_distance(const ObstacleShape& shape, const Eigen::Vector2d& a,
                        const Eigen::Vector2d& b);

/// The same, but if they share a point, minus the depth of the segment's deepest point: exact for
/// circles, within 0.1 mm (on the deep side) for polygons.
double signed_distance(const ObstacleShape& shape, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b);

}  // namespace limber
