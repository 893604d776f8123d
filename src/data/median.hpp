#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace limber {

/// Standard deviation over the median of |x|, for a normal distribution.
inline constexpr double kScaleOfMedian = 1.4826;

/// The upper one of two middle values. @pre values is not empty
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace limber
