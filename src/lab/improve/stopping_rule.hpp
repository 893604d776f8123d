#pragma once

#include <optional>
#include <vector>

namespace limber {

/// Where one model's plans ended after execution: distances from the goal, one for each environment
/// in the same order. None where there was no plan, or it was not executed to its end.
using EndDistances = std::vector<std::optional<double>>;

/// How much nearer the plans of one model end than those of another, over the environments in which
/// both were executed.
struct DistanceGain {
  int pairs = 0;
  double mean_m = 0.0;
  double standard_error_m = 0.0;  ///< of the mean; 0 where there are fewer than two pairs

  /// Whether it is beyond one standard error, and more than one pair says so.
  bool is_clear() const { return pairs > 1 && mean_m > standard_error_m; }
};

/// @pre both have the same size
DistanceGain gain_between(const EndDistances& before, const EndDistances& after);

struct RoundChoice {
  int best = 0;                     ///< round whose model is kept
  std::vector<DistanceGain> gains;  ///< of every round but the first, over `reference`
  std::vector<int> references;      ///< the round that each was compared with
  int rounds_without_gain = 0;      ///< at the end
};

/// Compares each round with the last one that had brought a clear gain (round 0, the model to start
/// from, counts as such), so that small gains may add up to a clear one. The best is the round
/// after that reference, or the reference, whose plans end nearest.
/// @param rounds  round 0 first; not empty
RoundChoice choose_round(const std::vector<EndDistances>& rounds);

/// Rounds without a clear gain, one after another, after which no more are made.
inline constexpr int kMaxRoundsWithoutGain = 2;

}  // namespace limber
