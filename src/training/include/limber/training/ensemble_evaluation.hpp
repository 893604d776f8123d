#pragma once
// For those who train and evaluate models.

#include <string>
#include <vector>

#include "limber/forward/ensemble_forward.hpp"
#include "limber/training/evaluation.hpp"

namespace limber {

/// How well an ensemble's spread predicts its error. A frame's spread is the root of the members'
/// mean squared distance from their mean tip; its error is that mean tip's distance from the
/// recorded one. NaN if there is no frame.
struct SpreadStatistics {
  double mean_cm = 0.0;
  /// Spearman's, between spread and error over frames: 1 if a larger spread always means a
  /// larger error, 0 if it says nothing; NaN if one of them never varies.
  double rank_correlation = 0.0;
  double covered_by_two = 0.0;  ///< share of frames whose error is at most twice the spread
  double factor_for_95 = 0.0;   ///< 95 % of the errors are at most this many times the spread
};

/// Errors of the mean of the members' predictions, each member rolled out by itself, and how well
/// their spread predicts these errors.
struct EnsembleErrors {
  TipErrors mean;
  SpreadStatistics spread;
};

struct EnsembleEvaluation {
  int members = 0;
  EnsembleErrors one_step;
  EnsembleErrors window_32;
  EnsembleErrors per_motion;
  EnsembleErrors open_loop;
};

/// @throws InputError if a prediction is not finite.
EnsembleEvaluation evaluate_ensemble(const EnsembleForward& ensemble,
                                     const std::vector<Episode>& episodes, int jobs = 0);

/// Spearman's rank correlation; equal values share the mean of their ranks. NaN if one side
/// never varies. @pre equal sizes
double rank_correlation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace limber
