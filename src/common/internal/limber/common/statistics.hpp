#pragma once

#include <span>
#include <vector>

namespace limber {

// Figures of samples: of n finite numbers in any order, n ≥ 1 unless said otherwise. A caller
// leaves out what is not known, such as frames that were not tracked.
//
// "95 %" is quantile(values, 0.95) wherever limber describes numbers that it has. A bound on a
// number that is still to come is another question with a name of its own: conformal_quantile
// (network/prediction_error.hpp), whose rank is higher.

/// Σ x / n, added in order.
double mean(std::span<const double> values);

/// √(Σ (x − mean)² / n): of the numbers themselves, not of what they are a sample of.
double standard_deviation(std::span<const double> values);

/// Of the mean: √(Σ (x − mean)² / (n − 1) / n). @pre n ≥ 2
double standard_error(std::span<const double> values);

/// Of a number that was found with one part of the data after the other left out, by its values
/// without each (the jackknife). @pre n ≥ 2
double jackknife_error(std::span<const double> left_out);

/// The value at position share · (n − 1) of the sorted numbers, linear between neighbours: NumPy's
/// default, and R's type 7 (Hyndman and Fan, 1996). Rises with share, from the smallest to the
/// largest number. @pre 0 ≤ share ≤ 1
double quantile(std::vector<double> values, double share);

/// quantile(values, 0.5): the middle one, or halfway between both.
double median(std::vector<double> values);

/// Standard deviation over the median of |x|, for a normal distribution.
inline constexpr double kScaleOfMedian = 1.4826;

/// Standard errors of a normal estimate to either end of its 95 % interval.
inline constexpr double kTwoSided95 = 1.96;

}  // namespace limber
