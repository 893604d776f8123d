#pragma once

#include <vector>

#include "exact_arm.hpp"
#include "limber/planning/environment.hpp"

namespace limber {

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
  Result over(const std::vector<ExactArm::Shape>& shapes) const;

 private:
  class MovingArc;

  /// Smallest distance of the arc's middle line from an obstacle, or `best` where that is less.
  double lowest(const MovingArc& arc, std::size_t obstacle, double best) const;

  const ArmDescription& arm_;
  const std::vector<Obstacle>& obstacles_;
  double tolerance_m_;
  std::vector<double> radius_m_;  // one a gap
  struct Disc {
    double x_m;
    double y_m;
    double radius_m;
  };
  std::vector<Disc> around_;  // one an obstacle, covers it
};

/// Distance of a point from an obstacle's outline, negative inside.
double exact_distance(const Obstacle& obstacle, double x_m, double y_m);

}  // namespace limber
