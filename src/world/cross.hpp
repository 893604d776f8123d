#pragma once

#include <Eigen/Core>

namespace limber {

/// z of a × b: twice the area of the triangle 0, a, b, positive if it is counter-clockwise.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace limber
