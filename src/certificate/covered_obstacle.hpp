#pragma once

#include <complex>
#include <limits>
#include <variant>
#include <vector>

#include "limber/world/environment.hpp"

namespace limber {

/// Axis-aligned; covers nothing at first.
struct CoveringBox {
  std::complex<double> low{std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()};
  std::complex<double> high{-std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};

  void cover(std::complex<double> p);
  void cover(const CoveringBox& other);
  /// Distance of a point, negative inside. No point of what the box covers is nearer or farther
  /// inside.
  double distance_m(std::complex<double> p) const;
  /// Squared distance between two boxes, 0 if they share a point.
  double squared_distance(const CoveringBox& other) const;
};

/// How far a point is from an obstacle.
struct Reading {
  double distance_m;  ///< from its outline, negative inside
  /// For a convex obstacle, the direction away from it: at any point q the distance is at least
  /// that at p plus (q − p)·away, because the obstacle lies behind a straight line. Otherwise 0.
  std::complex<double> away;
};

/// A polygon's edges in a tree of boxes, so that most of them need no check.
class PolygonOutline {
 public:
  explicit PolygonOutline(const Polygon& polygon);
  /// Exact.
  Reading read(std::complex<double> p) const;
  bool is_convex() const { return is_convex_; }
  const CoveringBox& box() const { return nodes_.front().box; }

 private:
  using Complex = std::complex<double>;
  static constexpr std::size_t kEdgesPerLeaf = 4;

  /// Edges `first` to `end`, which follow one another along the outline. The first child is the
  /// next node.
  struct Node {
    CoveringBox box;
    std::size_t first, end;
    std::size_t second_child = 0;  // 0: a leaf
  };
  struct Nearest;

  std::size_t add_node(std::size_t first, std::size_t end);
  void find_nearest(std::size_t node, Complex p, Nearest& nearest) const;
  int winding_number(std::size_t node, Complex p) const;

  std::vector<Complex> corners_;  // the first again at the end
  std::vector<Node> nodes_;
  bool is_convex_ = false;
};

/// An obstacle with a box about it.
struct CoveredObstacle {
  std::variant<Circle, Rectangle, PolygonOutline> shape;
  CoveringBox box;

  explicit CoveredObstacle(const Obstacle& obstacle);
  Reading read(std::complex<double> p) const;
};

}  // namespace limber
