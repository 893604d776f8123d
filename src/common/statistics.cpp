#include "limber/common/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "limber/common/mapped.hpp"

namespace limber {

namespace {

double sum_of_squares(std::span<const double> values) {
  const double middle = mean(values);
  return sum_of<double>(values,
                        [&](const double value) { return (value - middle) * (value - middle); });
}

}  // namespace

double mean(std::span<const double> values) {
  assert(!values.empty());
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double standard_deviation(std::span<const double> values) {
  return std::sqrt(sum_of_squares(values) / double(values.size()));
}

double standard_error(std::span<const double> values) {
  assert(values.size() >= 2);
  const auto count = double(values.size());
  return std::sqrt(sum_of_squares(values) / (count - 1.0) / count);
}

double jackknife_error(std::span<const double> left_out) {
  return double(left_out.size() - 1) * standard_error(left_out);
}

double quantile(std::vector<double> values, double share) {
  assert(!values.empty() && share >= 0.0 && share <= 1.0);
  const double position = share * double(values.size() - 1);
  const auto below = values.begin() + std::ptrdiff_t(position);
  std::nth_element(values.begin(), below, values.end());
  const double weight = position - std::floor(position);
  return weight == 0.0 ? *below
                       : std::lerp(*below, *std::min_element(below + 1, values.end()), weight);
}

double median(std::vector<double> values) {
  return quantile(std::move(values), 0.5);
}

}  // namespace limber
