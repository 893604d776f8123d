#pragma once

#include <Eigen/Core>

namespace limber {

/// How far the farthest plate of one shape (m×3, m ≥ 1) is from its place in another, in metres.
template <class A, class B>
double largest_plate_distance_m(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return double((a - b).template leftCols<2>().rowwise().norm().maxCoeff());
}

}  // namespace limber
