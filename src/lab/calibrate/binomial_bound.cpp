#include "binomial_bound.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limber {

namespace {

constexpr int kHalvings = 60;  // down to the last bit of a double

/// The share at which `is_too_large` turns true, in [0, 1]. @pre it does so once
template <class Test>
double first_share(Test&& is_too_large) {
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (is_too_large(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double binomial_at_most(int count, int runs, double share) {
  assert(count >= 0 && count <= runs && share >= 0.0 && share <= 1.0);
  if (count == runs || share <= 0.0) {
    return 1.0;
  }
  if (share >= 1.0) {
    return 0.0;
  }
  const double all = std::lgamma(runs + 1.0);
  double sum = 0.0;
  for (int k = 0; k <= count; ++k) {
    sum += std::exp(all - std::lgamma(k + 1.0) - std::lgamma(runs - k + 1.0) + k * std::log(share) +
                    (runs - k) * std::log1p(-share));
  }
  return std::min(sum, 1.0);
}

double share_at_most(int outside, int runs, double confidence) {
  if (outside == runs) {
    return 1.0;
  }
  return first_share(
      [&](double share) { return binomial_at_most(outside, runs, share) <= 1.0 - confidence; });
}

double share_at_least(int outside, int runs, double confidence) {
  if (outside == 0) {
    return 0.0;
  }
  return first_share([&](double share) {
    return 1.0 - binomial_at_most(outside - 1, runs, share) >= 1.0 - confidence;
  });
}

int min_runs(double level, double confidence) {
  constexpr double kRounding = 1e-9;
  return int(std::ceil(std::log(1.0 - confidence) / std::log(level) - kRounding));
}

double share_that_passes(int runs, double level, double confidence, double probability) {
  int allowed = 0;
  while (binomial_at_most(allowed + 1, runs, 1.0 - level) <= 1.0 - confidence) {
    ++allowed;
  }
  return first_share(
      [&](double share) { return binomial_at_most(allowed, runs, share) <= probability; });
}

}  // namespace limber
