#pragma once

#include <cmath>

namespace limber {

/// Of a hidden unit's gain on an arm of a family: between 1/55 and 55. Without a bound, units
/// whose gains went to 10⁵ made a training of 120 epochs diverge (docs/log/2026-11-30-families.md).
inline constexpr double kMaxLogGain = 4.0;

/// log γ(x): x itself where it is small, never beyond the bound.
template <class Scalar>
Scalar log_arm_gain(Scalar x) {
  const auto bound = static_cast<Scalar>(kMaxLogGain);
  return bound * std::tanh(x / bound);
}

/// ∂ log γ(x) / ∂x, by log γ(x).
template <class Scalar>
Scalar log_arm_gain_slope(Scalar log_gain) {
  const Scalar share = log_gain / static_cast<Scalar>(kMaxLogGain);
  return Scalar(1) - share * share;
}

}  // namespace limber
