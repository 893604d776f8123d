#include "stopping_rule.hpp"

#include <cassert>

#include "limber/common/statistics.hpp"

namespace limber {

DistanceGain gain_between(const EndDistances& before, const EndDistances& after) {
  assert(before.size() == after.size());
  std::vector<double> gains;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] && after[i]) {
      gains.push_back(*before[i] - *after[i]);
    }
  }
  DistanceGain result;
  result.pairs = static_cast<int>(gains.size());
  if (gains.empty()) {
    return result;
  }
  result.mean_m = mean(gains);
  if (gains.size() > 1) {
    result.standard_error_m = standard_error(gains);
  }
  return result;
}

RoundChoice choose_round(const std::vector<EndDistances>& rounds) {
  assert(!rounds.empty());
  RoundChoice choice;
  int reference = 0;
  double best_gain_m = 0.0;  // over the reference
  for (std::size_t k = 1; k < rounds.size(); ++k) {
    const int round = static_cast<int>(k);
    const DistanceGain gain = gain_between(rounds[static_cast<std::size_t>(reference)], rounds[k]);
    choice.gains.push_back(gain);
    choice.references.push_back(reference);
    if (gain.is_clear()) {
      reference = round;
      choice.best = round;
      best_gain_m = 0.0;
      choice.rounds_without_gain = 0;
      continue;
    }
    ++choice.rounds_without_gain;
    if (gain.pairs > 1 && gain.mean_m > best_gain_m) {
      best_gain_m = gain.mean_m;
      choice.best = round;
    }
  }
  return choice;
}

}  // namespace limber
