#include "limber/arm/characterisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include <fmt/format.h>
#include <Eigen/QR>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr int kMinPressures = 5;
constexpr double kBeyondLimit = 1.05;         // × p_max: readings above are left out
constexpr double kCoveredFrom = 0.3;          // × p_max: the lowest pressure > 0 must be below
constexpr double kCoveredTo = 0.9;            // × p_max: the highest must be above
constexpr double kRefusedResidual = 0.10;     // of full strain, of a refitted curve
constexpr double kNotedResidual = 0.05;       // of full strain
constexpr double kBareActuatorStrain = 0.24;  // between a mounted side (0.20) and a bare one (0.27)
// Seven digits move the slope by at most 5e-7 Σ k |a_k|, where the a_k are some tens of full
// strain: some ten rounds are enough.
constexpr int kHoldingTurns = 20;
constexpr double kMinHeldSlope = 1e-7;  // of the mean slope
constexpr int kRootGrid = 400;
constexpr double kRootResolution = 1e-9;
constexpr double kFallAllowed = 1e-12;  // of e' by rounding, when a candidate is judged
constexpr double kGoldenRatio = 0.6180339887498949;

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

StrainPolynomial per_kpa(const Eigen::Vector4d& fit, double limit_kpa) {
  StrainPolynomial c;
  for (int k = 0; k < 4; ++k) {
    c[std::size_t(k)] = seven_digits(fit[k] / std::pow(limit_kpa, k + 1));
  }
  return c;
}

void require_plain_values(const std::vector<BenchPoint>& points, double limit_kpa) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const BenchPoint& point = points[i];
    if (!std::isfinite(point.pressure_kpa) || !std::isfinite(point.strain)) {
      throw InputError(fmt::format("bench {}: ({} kPa, strain {}); expected finite numbers",
                                   point_name(i), point.pressure_kpa, point.strain));
    }
    if (point.pressure_kpa < -kBenchNoiseAroundZero * limit_kpa) {
      throw InputError(
          fmt::format("bench {}: {} kPa; expected the gauge pressure of the inflated side, "
                      "≥ 0 whichever side it is",
                      point_name(i), point.pressure_kpa));
    }
    if (std::abs(point.strain) >= 1.0) {
      throw InputError(
          fmt::format("bench {}: strain {}; expected a fraction of the length, between -1 "
                      "and 1 (per cent: divide by 100)",
                      point_name(i), point.strain));
    }
  }
}

void require_coverage(const std::vector<BenchPoint>& points, double limit_kpa) {
  std::set<double> pressures;
  double moment = 0.0;
  for (const BenchPoint& point : points) {
    pressures.insert(point.pressure_kpa);
    moment += point.pressure_kpa * point.strain;
  }
  refuse_if(int(pressures.size()) < kMinPressures,
            "{} bench points at {} distinct pressures up to {} kPa; expected at least {}",
            points.size(), pressures.size(), limit_kpa, kMinPressures);
  if (*pressures.rbegin() < kCoveredTo * limit_kpa) {
    throw InputError(fmt::format(
        "bench pressures end at {} kPa; expected at least {:.4g} kPa, 90 % of the segment's limit "
        "(are they in psi? 1 psi = 6.894757 kPa)",
        *pressures.rbegin(), kCoveredTo * limit_kpa));
  }
  const double lowest = *pressures.upper_bound(0.0);
  refuse_if(
      lowest > kCoveredFrom * limit_kpa,
      "the lowest bench pressure above 0 is {} kPa; expected one below {:.4g} kPa, 30 % of the "
      "segment's limit, or the curve between is a guess",
      lowest, kCoveredFrom * limit_kpa);
  refuse_if(moment >= 0.0,
            "the bench strain is positive: the side would lengthen under pressure. Expected "
            "contraction as a negative strain, (length - l0)/l0; if the data hold the amount of "
            "contraction, change their sign");
}

/// Points inside the range, readings around zero at zero.
std::vector<BenchPoint> within_range(const std::vector<BenchPoint>& points, double limit_kpa) {
  std::vector<BenchPoint> result;
  for (BenchPoint point : points) {
    if (point.pressure_kpa <= kBeyondLimit * limit_kpa) {
      point.pressure_kpa = std::max(0.0, point.pressure_kpa);
      result.push_back(point);
    }
  }
  return result;
}

void measure(const std::vector<BenchPoint>& points, StrainFit& fit) {
  double squares = 0.0;
  double largest = 0.0;
  for (const BenchPoint& point : points) {
    const double residual = -point.strain - strain_at(fit.polynomial, point.pressure_kpa);
    squares += residual * residual;
    largest = std::max(largest, std::abs(residual));
  }
  fit.points = int(points.size());
  fit.full_strain = strain_at(fit.polynomial, fit.pressure_limit_kpa);
  fit.rms_residual = std::sqrt(squares / double(points.size())) / fit.full_strain;
  fit.max_residual = largest / fit.full_strain;
}

void add_warnings(std::size_t given, StrainFit& fit) {
  if (const std::size_t left_out = given - std::size_t(fit.points); left_out > 0) {
    fit.warnings.push_back(fmt::format("{} points above {:.4g} kPa, 1.05 × the limit, left out",
                                       left_out, kBeyondLimit * fit.pressure_limit_kpa));
  }
  if (fit.rms_residual > kNotedResidual) {
    fit.warnings.push_back(
        fmt::format("the residual is {:.1f} % of full strain: scattered "
                    "data, or a shape that a quartic cannot follow",
                    100.0 * fit.rms_residual));
  }
  if (fit.full_strain > kBareActuatorStrain) {
    fit.warnings.push_back(
        fmt::format("full strain is {:.2f}. Was a bare actuator measured? It contracts "
                    "about a third more than the side of a whole segment, whose elasticity "
                    "holds it back; the error of the no-load model is then 27 cm instead "
                    "of 16 on limber's virtual arm. Measure one whole, free segment",
                    fit.full_strain));
  }
}

/// The best polynomial that never falls, after rounding too: rounding can make a slope negative
/// that was held at exactly zero, so it is held a little higher, twice as high in each round.
StrainPolynomial never_falling(const MonotoneFit& problem, double limit_kpa) {
  double held = 0.0;
  for (int turn = 0; turn < kHoldingTurns; ++turn) {
    const Eigen::Vector4d fit = problem.monotone(held);
    const StrainPolynomial polynomial = per_kpa(fit, limit_kpa);
    if (min_strain_slope(polynomial, limit_kpa).slope_per_kpa >= 0.0) {
      return polynomial;
    }
    held = std::max(2.0 * held, kMinHeldSlope * fit.sum());  // Σ a_k = e(1), the mean slope
  }
  throw InputError(fmt::format(
      "no polynomial of 7 digits that never falls was found in {} rounds. Remove readings that are "
      "far off the others, or measure at more pressures",
      kHoldingTurns));
}

}  // namespace

StrainFit fit_strain_polynomial(const std::vector<BenchPoint>& points, double pressure_limit_kpa) {
  require_plain_values(points, pressure_limit_kpa);
  const std::vector<BenchPoint> used = within_range(points, pressure_limit_kpa);
  require_coverage(used, pressure_limit_kpa);

  StrainFit fit;
  fit.pressure_limit_kpa = pressure_limit_kpa;
  const MonotoneFit problem(used, pressure_limit_kpa);
  fit.polynomial = per_kpa(problem.unconstrained(), pressure_limit_kpa);
  if (min_strain_slope(fit.polynomial, pressure_limit_kpa).slope_per_kpa < 0.0) {
    fit.polynomial = never_falling(problem, pressure_limit_kpa);
    fit.refitted = true;
  }
  measure(used, fit);
  if (const std::string reason = why_unusable(fit.polynomial, pressure_limit_kpa);
      !reason.empty()) {
    throw InputError("the fitted polynomial " + reason);
  }
  refuse_if(
      fit.refitted && fit.rms_residual > kRefusedResidual,
      "the bench strain rises and falls with pressure: the best curve that never falls leaves a "
      "residual of {:.1f} % of full strain, expected at most {:.0f} %",
      100.0 * fit.rms_residual, 100.0 * kRefusedResidual);
  add_warnings(points.size(), fit);
  return fit;
}

void require_characterisable(const ArmDescription& arm) {
  require_pressure_driven(arm, "characterisation");
  if (arm.no_load != NoLoadKind::strain_polynomial) {
    throw InputError(fmt::format(
        "arm '{}' says 'no_load: {}': its no-load model has no strain polynomial to fit. Take that "
        "line out of the arm file, or leave characterisation out",
        arm.name, to_string(arm.no_load)));
  }
}

namespace {

/// The same bench test fitted on another machine differs in the last digit. Where the fit says what
/// the arm file says already, the file's numbers stay, so that the arm keeps its hash.
void keep_what_agrees(const StrainPolynomial& of_file, StrainFit& fit) {
  fit.kept =
      why_unusable(of_file, fit.pressure_limit_kpa).empty() &&
      max_strain_difference(of_file, fit.polynomial, fit.pressure_limit_kpa).strain <= kSameStrain;
  if (fit.kept) {
    fit.polynomial = of_file;
  }
}

}  // namespace

CharacterisedArm characterise(const ArmDescription& arm, const BenchData& bench) {
  require_characterisable(arm);
  refuse_if(int(bench.size()) != arm.segment_count(), "bench data of {} segments; arm '{}' has {}",
            bench.size(), arm.name, arm.segment_count());
  CharacterisedArm result{arm, {}};
  for (std::size_t i = 0; i < bench.size(); ++i) {
    throw_if_interrupted();
    try {
      result.fits.push_back(
          fit_strain_polynomial(bench[i], arm.segments[i].pressure_limit_kpa.largest_kpa()));
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", segment_name(i), error.what()));
    }
    keep_what_agrees(arm.segments[i].strain_polynomial, result.fits.back());
    result.arm.segments[i].strain_polynomial = result.fits.back().polynomial;
  }
  return result;
}

}  // namespace limber
