#pragma once

#include <vector>

namespace limber {

/// Figures that describe how values spread (common/statistics.hpp).
struct Spread {
  double mean = 0.0;
  double p05 = 0.0, p25 = 0.0, median = 0.0, p75 = 0.0, p95 = 0.0;
};

/// @param values  finite, at least one.
Spread spread_of(const std::vector<double>& values);

/// Density at even steps from the lowest to the highest value, the largest being 1: a Gaussian
/// kernel, bandwidth by Silverman's rule (1986, 3.31). One step of density 1 if all are equal.
struct DensityOutline {
  std::vector<double> at;
  std::vector<double> density;  ///< in [0, 1]
};
DensityOutline density_outline(const std::vector<double>& values, int steps);

}  // namespace limber
