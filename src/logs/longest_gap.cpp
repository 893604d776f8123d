#include "longest_gap.hpp"

#include <algorithm>

#include "limber/data/median_rate.hpp"

namespace limber {

namespace {

constexpr double kShortestDefaultGap_s = 0.25;
constexpr double kDefaultGapSteps = 2.5;

}  // namespace

double longest_gap_in_s(const LongestGap& gap, const std::vector<double>& time_s) {
  return gap.given_s.value_or(
      std::max(kShortestDefaultGap_s, kDefaultGapSteps * quantile_step_s(time_s, kUsualSteps)));
}

std::string in_words(const LongestGap& gap) {
  return gap.given_s ? fmt::format("{}", *gap.given_s)
                     : fmt::format("{} usual steps or {}", kDefaultGapSteps, kShortestDefaultGap_s);
}

}  // namespace limber
