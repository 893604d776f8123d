#include "monotone_fit.hpp"

#include <algorithm>

#include <Eigen/QR>

namespace limber {

namespace {

constexpr int kRootGrid = 400;
constexpr double kRootResolution = 1e-9;
constexpr double kFallAllowed = 1e-12;  // of e' by rounding, when a candidate is judged
constexpr double kGoldenRatio = 0.6180339887498949;

/// e(u) whose slope is (u − c)² u and (u − c)² (1 − u), as columns of a1 … a4.
Eigen::Matrix<double, 4, 2> double_root_basis(double c) {
  Eigen::Matrix<double, 4, 2> basis;
  basis.col(0) << 0.0, c * c / 2.0, -2.0 * c / 3.0, 0.25;
  basis.col(1) << c * c, -c - c * c / 2.0, (1.0 + 2.0 * c) / 3.0, -0.25;
  return basis;
}

bool rises(const Eigen::Vector4d& a) {
  const StrainPolynomial c{a[0], a[1], a[2], a[3]};
  return min_strain_slope(c, 1.0).slope_per_kpa >= -kFallAllowed;
}

}  // namespace

MonotoneFit::MonotoneFit(const std::vector<BenchPoint>& points, double pressure_limit_kpa) {
  Eigen::MatrixX4d a(points.size(), 4);
  Eigen::VectorXd e(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = points[i].pressure_kpa / pressure_limit_kpa;
    a.row(Eigen::Index(i)) << u, u * u, u * u * u, u * u * u * u;
    e[Eigen::Index(i)] = -points[i].strain;
  }
  const Eigen::HouseholderQR<Eigen::MatrixX4d> qr(a);
  r_ = qr.matrixQR().topRows<4>().triangularView<Eigen::Upper>();
  d_ = (qr.householderQ().transpose() * e).head<4>();
}

Eigen::Vector4d MonotoneFit::unconstrained() const {
  return r_.triangularView<Eigen::Upper>().solve(d_);
}

Eigen::Vector4d MonotoneFit::monotone(double slope) const {
  // e = slope·u + a curve that never falls.
  const Eigen::Vector4d floor(slope, 0.0, 0.0, 0.0);
  const Eigen::Vector4d target = d_ - r_ * floor;

  Cone flat_at_both_ends;  // ∫ u²(1 − u), ∫ u(1 − u)²
  flat_at_both_ends.col(0) << 0.0, 0.0, 1.0 / 3.0, -0.25;
  flat_at_both_ends.col(1) << 0.0, 0.5, -2.0 / 3.0, 0.25;
  Plane flat_at_start = Plane::Zero();  // ∫ u, ∫ u², ∫ u³
  flat_at_start.bottomRows<3>().setIdentity();
  Plane flat_at_end;  // ∫ (1 − u), ∫ (1 − u) u, ∫ (1 − u) u²
  flat_at_end.col(0) << 1.0, -0.5, 0.0, 0.0;
  flat_at_end.col(1) << 0.0, 0.5, -1.0 / 3.0, 0.0;
  flat_at_end.col(2) << 0.0, 0.0, 1.0 / 3.0, -0.25;

  Eigen::Vector4d best = best_with_double_root(target);
  for (const Eigen::Vector4d& candidate :
       {best_in_cone(flat_at_both_ends, target), best_in_plane(flat_at_start, target),
        best_in_plane(flat_at_end, target)}) {
    if (rises(candidate) && squares(candidate, target) < squares(best, target)) {
      best = candidate;
    }
  }
  return floor + best;
}

double MonotoneFit::squares(const Eigen::Vector4d& a, const Eigen::Vector4d& target) const {
  return (r_ * a - target).squaredNorm();
}

/// Non-negative least squares in two unknowns: both, or the better one alone, or none.
Eigen::Vector4d MonotoneFit::best_in_cone(const Cone& basis, const Eigen::Vector4d& target) const {
  const Cone columns = r_ * basis;
  const Eigen::Vector2d both = columns.colPivHouseholderQr().solve(target);
  if (both.minCoeff() >= 0.0) {
    return basis * both;
  }
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (int k = 0; k < 2; ++k) {
    const double alone = columns.col(k).dot(target) / columns.col(k).squaredNorm();
    const Eigen::Vector4d candidate = basis.col(k) * std::max(0.0, alone);
    if (squares(candidate, target) < squares(best, target)) {
      best = candidate;
    }
  }
  return best;
}

Eigen::Vector4d MonotoneFit::best_in_plane(const Plane& basis,
                                           const Eigen::Vector4d& target) const {
  return basis * (r_ * basis).colPivHouseholderQr().solve(target);
}

Eigen::Vector4d MonotoneFit::best_with_double_root(const Eigen::Vector4d& target) const {
  const auto curve = [&](double c) { return best_in_cone(double_root_basis(c), target); };
  const auto cost = [&](double c) { return squares(curve(c), target); };
  double best = 0.0;
  for (int k = 1; k <= kRootGrid; ++k) {
    const double c = double(k) / kRootGrid;
    best = cost(c) < cost(best) ? c : best;
  }
  // Golden section between the neighbours.
  double low = std::max(0.0, best - 1.0 / kRootGrid);
  double high = std::min(1.0, best + 1.0 / kRootGrid);
  while (high - low > kRootResolution) {
    const double left = high - kGoldenRatio * (high - low);
    const double right = low + kGoldenRatio * (high - low);
    (cost(left) < cost(right) ? high : low) = cost(left) < cost(right) ? right : left;
  }
  return curve(0.5 * (low + high));
}

}  // namespace limber
