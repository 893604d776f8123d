#pragma once

#include <Eigen/Core>

#include "limber/arm/backbone.hpp"

namespace limber {

/// An extended Kalman filter on the arm's shape: how much of the difference between a measured and
/// a predicted backbone is believed. A tracker's noise moves every plate by itself, and a shape of
/// such plates is none that an arm can have: plates stand beside each other by a tenth of the
/// noise, if the gap between them bends as one arc. What the model misses bends gaps. So the error
/// of a prediction has a covariance in the coordinates of gaps (network/backbone_layout.hpp,
/// gap_poses): gaps turn, and with each turn the next plate moves aside by half a gap; they become
/// longer, and leave the arc, by a little. Where measurements are off by more than that and the
/// noise explain, as when friction is not what the model knows, the covariance is widened until
/// they are not (a strong tracking filter, Zhou and Frank 1996). Then the shape is the measured
/// one.
///
/// m points, g = m − 1 gaps.
class ShapeFilter {
 public:
  /// @param gap_length_m  of each gap, size g
  /// @param noise_m       deviation of a measured x or y, > 0; of a heading as much over a gap's
  ///                      length
  ShapeFilter(Eigen::VectorXd gap_length_m, double noise_m);

  /// One more frame is predicted: it is known less well.
  void predict() { covariance_ += growth_; }
  /// Between both.
  /// @pre the arm's number of points; `predicted` is where the last `predict` led
  Backbone corrected(const Backbone& predicted, const Backbone& measured);

 private:
  Eigen::VectorXd gap_length_m_;
  double noise_m_;
  Eigen::MatrixXd growth_;      // of the covariance in a frame, 3g×3g
  Eigen::MatrixXd covariance_;  // of the prediction's error in gap poses, 3g×3g
};

}  // namespace limber
