#include "axis_ticks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

namespace limber {

namespace {

/// Share of a step by which a tick may lie outside the range, for rounding alone.
constexpr double kSlack = 1e-9;
/// If a range is narrower than this share of its values, doubles can't tell its ticks apart.
constexpr double kNarrowest = 1e-9;

std::string tick_label(double value, double step) {
  const double magnitude = std::abs(value);
  if (step >= 1e6 || (step < 1e-4 && magnitude < 1.0)) {
    return value == 0.0 ? "0" : fmt::format("{:.3g}", value);
  }
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + kSlack)));
  return fmt::format("{:.{}f}", value, decimals);
}

std::string power_of_ten_label(double value) {
  return value >= 1e-3 && value < 1e5 ? fmt::format("{:g}", value) : fmt::format("{:.0e}", value);
}

}  // namespace

double nice_step(double low, double high, int count) {
  assert(low < high && count >= 1);
  // Divided first: the difference of two huge doubles overflows.
  const double rough = high / count - low / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double digit = rough / power;
  if (digit < 1.5) {
    return power;
  }
  if (digit < 3.5) {
    return 2.0 * power;
  }
  return digit < 7.5 ? 5.0 * power : 10.0 * power;
}

NiceRange nice_range(double low, double high, int count) {
  if (low > high) {
    std::swap(low, high);
  }
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (high - low <= kNarrowest * magnitude || magnitude == 0.0) {
    const double half = magnitude == 0.0 ? 1.0 : 0.1 * magnitude;
    low -= half;
    high += half;
  }
  const double step = nice_step(low, high, count);
  return {std::floor(low / step + kSlack) * step, std::ceil(high / step - kSlack) * step};
}

AxisTicks linear_ticks(double low, double high, int count) {
  const double step = nice_step(low, high, count);
  const double first = std::ceil(low / step - kSlack);
  const int tick_count = 1 + static_cast<int>(std::floor(high / step + kSlack) - first);
  AxisTicks ticks;
  for (int i = 0; i < tick_count; ++i) {
    const double index = first + i;
    const double value = index == 0.0 ? 0.0 : index * step;  // never −0
    ticks.values.push_back(value);
    ticks.labels.push_back(tick_label(value, step));
  }
  return ticks;
}

NiceRange nice_logarithmic_range(double low, double high) {
  assert(low > 0.0 && low <= high);
  NiceRange range{low, high};
  const double below = std::pow(10.0, std::floor(std::log10(low)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * below <= low * (1.0 + kSlack)) {
      range.low = digit * below;
    }
  }
  const double power = std::pow(10.0, std::floor(std::log10(high)));
  for (const double digit : {10.0, 5.0, 2.0, 1.0}) {
    if (digit * power >= high * (1.0 - kSlack)) {
      range.high = digit * power;
    }
  }
  if (range.high <= range.low * (1.0 + kSlack)) {
    range.low /= 2.0;
    range.high *= 2.0;
  }
  return range;
}

AxisTicks logarithmic_ticks(double low, double high) {
  assert(low > 0.0 && low < high);
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  const int decades = last - first;
  const bool few = std::log10(high / low) < 3.0;
  const int stride = std::max(1, decades / 8);
  AxisTicks ticks;
  for (int exponent = first; exponent <= last; exponent += stride) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, exponent);
      if (value < low * (1.0 - kSlack) || value > high * (1.0 + kSlack) || (digit > 1.0 && !few)) {
        continue;
      }
      ticks.values.push_back(value);
      ticks.labels.push_back(power_of_ten_label(value));
    }
  }
  return ticks;
}

}  // namespace limber
