#pragma once

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

/// A test of so many runs is passed where share_at_most of those outside is no more than 1 − level.
/// @return the share outside of all runs with which it is passed with that probability
/// @pre runs ≥ min_runs(level, confidence), 0 < probability < 1
double share_that_passes(int runs, double level, double confidence, double probability);

}  // namespace limber
