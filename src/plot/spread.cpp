#include "spread.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "limber/common/statistics.hpp"

namespace limber {

namespace {

double silverman_bandwidth(const std::vector<double>& values, const Spread& spread) {
  const double deviation = standard_deviation(values);
  const double quartiles = (spread.p75 - spread.p25) / 1.34;
  const double width = quartiles > 0.0 ? std::min(deviation, quartiles) : deviation;
  return 0.9 * width * std::pow(double(values.size()), -0.2);
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  return {mean(values),   quantile(values, 0.05), quantile(values, 0.25),
          median(values), quantile(values, 0.75), quantile(values, 0.95)};
}

DensityOutline density_outline(const std::vector<double>& values, int steps) {
  assert(!values.empty() && steps >= 2);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest;
  const double width = *highest - low;
  const double bandwidth = silverman_bandwidth(values, spread_of(values));
  if (width <= 0.0 || bandwidth <= 0.0) {
    return {{low}, {1.0}};
  }
  // Values are counted in fine bins first, so that a million of them cost no more than a thousand.
  constexpr int kFineBins = 512;
  std::vector<double> counts(kFineBins, 0.0);
  for (const double value : values) {
    const long bin = std::lround((value - low) / width * (kFineBins - 1));
    counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  DensityOutline outline;
  for (int step = 0; step < steps; ++step) {
    const double at = low + width * step / (steps - 1);
    double density = 0.0;
    for (int bin = 0; bin < kFineBins; ++bin) {
      const double distance = (low + width * bin / (kFineBins - 1) - at) / bandwidth;
      density += counts[static_cast<std::size_t>(bin)] * std::exp(-0.5 * distance * distance);
    }
    outline.at.push_back(at);
    outline.density.push_back(density);
  }
  const double largest = *std::max_element(outline.density.begin(), outline.density.end());
  for (double& density : outline.density) {
    density = largest > 0.0 ? density / largest : 1.0;
  }
  return outline;
}

}  // namespace limber
