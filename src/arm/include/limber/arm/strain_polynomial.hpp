#pragma once
// For those who ask a model where the arm goes.

#include <algorithm>
#include <array>
#include <string>

namespace limber {

/// Contraction strain of an inflated side over its gauge pressure, e = c1 p + c2 p² + c3 p³ + c4 p⁴
/// (docs/model.md (9)); p in kPa, e ≥ 0 the amount of contraction. c[0] is c1, in 1/kPa.
using StrainPolynomial = std::array<double, 4>;

/// P(p), (9).
inline double strain_at(const StrainPolynomial& c, double pressure_kpa) {
  const double p = pressure_kpa;
  return p * (c[0] + p * (c[1] + p * (c[2] + p * c[3])));
}

/// dP/dp in 1/kPa.
inline double strain_slope_at(const StrainPolynomial& c, double pressure_kpa) {
  const double p = pressure_kpa;
  return c[0] + p * (2.0 * c[1] + p * (3.0 * c[2] + p * 4.0 * c[3]));
}

/// P(p), p ≥ 0; above the limit it goes on along its end slope, and never falls there.
inline double strain_beyond(const StrainPolynomial& c, double pressure_limit_kpa,
                            double pressure_kpa) {
  if (pressure_kpa <= pressure_limit_kpa) {
    return strain_at(c, pressure_kpa);
  }
  const double slope = std::max(0.0, strain_slope_at(c, pressure_limit_kpa));
  return strain_at(c, pressure_limit_kpa) + slope * (pressure_kpa - pressure_limit_kpa);
}

/// Where on [0, p_max] the strain rises least, and how fast: negative where it falls.
struct LeastSlope {
  double pressure_kpa = 0.0;
  double slope_per_kpa = 0.0;
};

/// Exact: it looks at the ends and at the two points where the slope's own derivative vanishes.
LeastSlope min_strain_slope(const StrainPolynomial& c, double pressure_limit_kpa);

/// Strains this close over the whole pressure range are those of the same segment. This is ten
/// times the rounding difference between two machines for one bench test, and too little for a
/// certificate to notice (5e-6 in every segment of a long, thin arm moves its tip by 0.05 mm).
inline constexpr double kSameStrain = 5e-6;

/// Where two polynomials are farthest apart, and how far.
struct StrainDifference {
  double pressure_kpa = 0.0;
  double strain = 0.0;  ///< ≥ 0
};

/// Over [0, p_max], to a thousandth of itself.
StrainDifference max_strain_difference(const StrainPolynomial& a, const StrainPolynomial& b,
                                       double pressure_limit_kpa);

/// Why no model can use the polynomial up to its pressure limit: it falls somewhere, or its full
/// strain is not between 0 and 1. Empty if it is fine.
std::string why_unusable(const StrainPolynomial& c, double pressure_limit_kpa);

}  // namespace limber
