#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/characterisation.hpp"

namespace limber {

/// Least squares for e(u) = a1 u + a2 u² + a3 u³ + a4 u⁴ over u = p/p_max, with or without the
/// demand that the slope e'(u), a cubic, nowhere falls below a bound on [0, 1].
///
/// docs/model.md (10): a cubic that is ≥ 0 on [0, 1] and touches 0 there does so in one of four
/// ways, so the constrained optimum is the best of four small problems, each solved exactly:
///   e' = u q(u), e' = (1 − u) q(u), q any quadratic that leaves e' ≥ 0;
///   e' = u (1 − u) (α u + β (1 − u));
///   e' = (u − c)² (α u + β (1 − u)), α, β ≥ 0 and c in [0, 1] searched in one dimension.
class MonotoneFit {
 public:
  /// @pre at least 4 distinct pressures > 0, everything finite.
  MonotoneFit(const std::vector<BenchPoint>& points, double pressure_limit_kpa);

  /// a1 … a4 of the plain least-squares fit.
  Eigen::Vector4d unconstrained() const;

  /// a1 … a4 of the best fit with e'(u) ≥ slope on [0, 1], which the plain fit is not. slope ≥ 0.
  Eigen::Vector4d monotone(double slope) const;

 private:
  using Cone = Eigen::Matrix<double, 4, 2>;
  using Plane = Eigen::Matrix<double, 4, 3>;

  double squares(const Eigen::Vector4d& a, const Eigen::Vector4d& target) const;
  Eigen::Vector4d best_in_cone(const Cone& basis, const Eigen::Vector4d& target) const;
  Eigen::Vector4d best_in_plane(const Plane& basis, const Eigen::Vector4d& target) const;
  Eigen::Vector4d best_with_double_root(const Eigen::Vector4d& target) const;

  // ‖A a − e‖² = ‖R a − d‖² + a constant: every candidate costs a 4×4 product.
  Eigen::Matrix4d r_;
  Eigen::Vector4d d_;
};

}  // namespace limber
