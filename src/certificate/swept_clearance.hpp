#pragma once

#include <functional>
#include <vector>

#include "covered_obstacle.hpp"
#include "exact_arm.hpp"
#include "give_up.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// By how much the arm is thicker at its plates; between two of them by the larger.
struct SweptRoom {
  std::vector<double> plate_m;  ///< empty: nowhere
  /// A plate has this share of it where it is in the first shape, and more in proportion to its
  /// distance from there, up to all of it after `full_after_m`; 0: all of it everywhere.
  double start_share = 1.0;
  double full_after_m = 0.0;
};

/// Smallest distance between a moving arm and obstacles, by bounds on how fast distances change.
///
/// The gap between two plates is the arc through both that turns by the difference of their
/// headings; between frames plates move straight and turn evenly. Distance to an obstacle changes
/// by no more than a point moves, over time and along the arc. So the value at the middle of a cell
/// of (time, position on the arc), less half of both movements, is a lower bound of the cell. Cells
/// that may hold less than the best value found so far are halved. A convex obstacle lies behind a
/// straight line, so of the movement along the arc only the part toward that line counts.
///
/// Gaps and obstacles whose boxes are farther apart than the best value are skipped. So the search
/// starts from a good value: that of the plate that comes nearest, and of the gaps beside it.
/// Threads: constant after construction.
class SweptClearance {
 public:
  SweptClearance(const ArmDescription& arm, const std::vector<Obstacle>& obstacles,
                 double tolerance_m);

  struct Result {
    double value_m;  ///< from below, at most the tolerance below the true one
    int frame = -1;  ///< the frame that the motion there leads to
    int gap = -1;
    int obstacle = -1;
    bool is_finished = true;  ///< false: given up, and nothing else here is defined
  };
  /// Over the motion from each shape to the next; a single shape stands still. @pre no gap turns by
  /// more than half a turn, and every number is finite.
  /// @param room  in a motion that of its thicker end
  /// @param give_up  called every few dozen microseconds: whether to stop
  /// @throws Interrupted if a signal comes meanwhile.
  Result over(const std::vector<ExactArm::Shape>& shapes, const std::function<bool()>& give_up = {},
              const SweptRoom& room = {}) const;

 private:
  class MovingArc;
  class Search;

  double tolerance_m_;
  std::vector<double> radius_m_;  // one per gap
  std::vector<CoveredObstacle> obstacles_;
};

}  // namespace limber
