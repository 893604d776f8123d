#include "limber/data/median_rate.hpp"

#include <utility>

#include "limber/common/statistics.hpp"

namespace limber {

double quantile_step_s(const std::vector<double>& time_s, double share) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    steps.push_back(time_s[i] - time_s[i - 1]);
  }
  return quantile(std::move(steps), share);
}

double median_rate_hz(const std::vector<double>& time_s) {
  return 1.0 / quantile_step_s(time_s, 0.5);
}

}  // namespace limber
