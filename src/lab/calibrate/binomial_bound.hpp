#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace limber {

/// P(X ≤ count) for X of `runs` trials with probability `share` each: the exact sum of its terms.
/// @pre 0 ≤ count ≤ runs, 0 ≤ share ≤ 1
double binomial_at_most(int count, int runs, double share);

/// Clopper–Pearson: the share of all runs that `outside` of `runs` leave open with the given
/// confidence, from above and from below. No runs leave everything open.
/// @pre 0 ≤ outside ≤ runs, 0 < confidence < 1
double share_at_most(int outside, int runs, double confidence);
double share_at_least(int outside, int runs, double confidence);

/// Runs that can show that no more than 1 − level of all runs are outside, if none of them is.
/// @pre 0 < level < 1, 0 < confidence < 1
int min_runs(double level, double confidence);

/// The narrowest factor of a list, the largest first, that holds its test (docs/tube.md,
/// Calibration): from `start` towards narrower ones until one is refused. Where the first is
/// refused, towards wider ones by two steps each until one holds, and then the one between.
///
/// A test that accepts a factor that doesn't hold has a probability of at most p, and whoever
/// chose `start` has not seen its runs. Then the answer doesn't hold with a probability of at most
/// max_tests · p: on the way down only the first factor that doesn't hold can be accepted wrongly
/// before the search ends (fixed sequence); otherwise there are no more tests than that.
/// @param count  of factors in the list
/// @param max_tests  where the first is refused; it counts
/// @param holds  tests factor k; every k is asked for once at most
/// @pre start < count, max_tests ≥ 1
std::optional<std::size_t> narrowest_factor(std::size_t start, std::size_t count, int max_tests,
                                            const std::function<bool(std::size_t)>& holds);

}  // namespace limber
