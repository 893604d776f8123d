#include "limber/arm/strain_polynomial.hpp"

#include <cmath>

#include <fmt/format.h>

namespace limber {

namespace {

// A fit whose slope was held at zero may fall by rounding, this much of full strain over the whole
// range; a thousandth of what any bench resolves.
constexpr double kRoundingOfSlope = 1e-9;

// A quartic between grid points this close rises above both by less than a thousandth.
constexpr int kDifferenceGrid = 200;

}  // namespace

LeastSlope min_strain_slope(const StrainPolynomial& c, double pressure_limit_kpa) {
  LeastSlope min{0.0, c[0]};
  const auto consider = [&](double pressure_kpa) {
    if (pressure_kpa > 0.0 && pressure_kpa <= pressure_limit_kpa) {
      const double slope = strain_slope_at(c, pressure_kpa);
      if (slope < min.slope_per_kpa) {
        min = {pressure_kpa, slope};
      }
    }
  };
  consider(pressure_limit_kpa);
  // 2 c2 + 6 c3 p + 12 c4 p² = 0, in the form that survives c4 = 0.
  const double half = 3.0 * c[2];
  const double discriminant = half * half - 24.0 * c[3] * c[1];
  if (discriminant >= 0.0) {
    const double q = -(half + std::copysign(std::sqrt(discriminant), half));
    consider(q / (12.0 * c[3]));
    consider(2.0 * c[1] / q);
  }
  return min;
}

StrainDifference max_strain_difference(const StrainPolynomial& a, const StrainPolynomial& b,
                                       double pressure_limit_kpa) {
  StrainDifference largest;
  for (int k = 1; k <= kDifferenceGrid; ++k) {
    const double p = pressure_limit_kpa * k / kDifferenceGrid;
    const double apart = std::abs(strain_at(a, p) - strain_at(b, p));
    if (!(apart <= largest.strain)) {  // no number counts as any difference
      largest = {p, apart};
    }
  }
  return largest;
}

std::string why_unusable(const StrainPolynomial& c, double pressure_limit_kpa) {
  const double full = strain_at(c, pressure_limit_kpa);
  if (!(full > 0.0 && full < 1.0)) {
    return fmt::format("gives a strain of {:.4g} at the limit of {} kPa; expected between 0 and 1",
                       full, pressure_limit_kpa);
  }
  const LeastSlope min = min_strain_slope(c, pressure_limit_kpa);
  if (min.slope_per_kpa * pressure_limit_kpa < -kRoundingOfSlope * full) {
    return fmt::format(
        "falls at {:.4g} kPa; expected strain that never falls between 0 and the limit of {} kPa "
        "('limber characterize' fits such a polynomial)",
        min.pressure_kpa, pressure_limit_kpa);
  }
  return {};
}

}  // namespace limber
