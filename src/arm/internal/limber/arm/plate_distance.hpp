#pragma once

#include <Eigen/Core>

namespace limber {

/// How far each plate of one shape (m×3, m ≥ 1) is from its place in another, in metres: m numbers,
/// as an expression that borrows both shapes. Lengths are taken in double, of differences in the
/// shapes' own precision.
template <class A, class B>
auto plate_distances_m(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return (a.derived() - b.derived())
      .template leftCols<2>()
      .template cast<double>()
      .rowwise()
      .norm();
}

/// The same of the plate that is farthest from its place.
template <class A, class B>
double largest_plate_distance_m(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return plate_distances_m(a, b).maxCoeff();
}

/// The same of places alone: m×2, in space m×3.
template <class A, class B>
double largest_place_distance_m(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return (a.derived() - b.derived()).template cast<double>().rowwise().norm().maxCoeff();
}

}  // namespace limber
