#include "limber/data/median_rate.hpp"

#include <utility>

#include "limber/common/statistics.hpp"
namespace limber {

double median_rate_hz(const std::vector<double>& time_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    steps.push_back(time_s[i] - time_s[i - 1]);
  }
  return 1.0 / median(std::move(steps));
}

}  // namespace limber
