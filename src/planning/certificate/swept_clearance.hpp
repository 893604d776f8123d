#pragma once

#include <complex>
#include <limits>
#include <variant>
#include <vector>

#include "exact_arm.hpp"
#include "limber/planning/environment.hpp"

namespace limber {

/// Axis-aligned; covers nothing at first.
struct CoveringBox {
  std::complex<double> low{std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::infinity()};
  std::complex<double> high{-std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};
};

/// A polygon's edges, some under each box, so that most of them are not looked at.
class PolygonOutline {
 public:
  explicit PolygonOutline(const Polygon& polygon);
  /// Of a point, negative inside. Exact.
  double distance_m(std::complex<double> p) const;

 private:
  static constexpr std::size_t kEdgesPerBox = 16;
  std::vector<std::complex<double>> corners_;  // the first again at the end
  std::vector<CoveringBox> boxes_;
};

/// Smallest distance between a moving arm and obstacles, by a Lipschitz bound alone.
///
/// The gap between two plates is the arc through both that turns by the difference of their
/// headings; between frames plates move straight and turn evenly. Distance to an obstacle changes
/// by no more than a point's way, over time as along the arc. So the value at the middle of a cell
/// of (time, place on the arc), less half of both ways, bounds the cell from below; cells that may
/// hold less than the best value found so far are halved.
class SweptClearance {
 public:
  SweptClearance(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                 double tolerance_m);

  struct Result {
    double value_m;  ///< from below, at most the tolerance below the true one
    int frame = -1;  ///< the frame that the motion there leads to
    int gap = -1;
    int obstacle = -1;
  };
  /// Over the motion from each shape to the next; a single shape stands still. @pre no gap turns by
  /// more than half a turn, and every number is finite.
  /// @throws Interrupted where a signal comes meanwhile.
  Result over(const std::vector<ExactArm::Shape>& shapes) const;

 private:
  class MovingArc;

  /// Smallest distance of the arc's middle line from an obstacle, or `best` where that is less.
  double lowest(const MovingArc& arc, std::size_t obstacle, double best) const;

  struct CoveredObstacle {
    CoveringBox box;
    std::variant<Circle, Rectangle, PolygonOutline> shape;

    /// From its outline, negative inside.
    double distance_m(std::complex<double> p) const;
  };
  static CoveredObstacle covered(const Obstacle& obstacle);

  double tolerance_m_;
  std::vector<double> radius_m_;  // one a gap
  std::vector<CoveredObstacle> obstacles_;
};

}  // namespace limber
