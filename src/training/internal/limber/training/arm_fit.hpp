#pragma once
// For those who train and evaluate models.

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Which arm of a family was recorded: e with the smallest error of predictions over windows of
/// frames, and how sure that is (docs/families.md).
struct ArmFit {
  CompensationModel model;           ///< of that arm, without a record of this fit
  double distance = 0.0;             ///< |e| / √k: about 1 for an arm of the family
  double distance_to_nearest = 0.0;  ///< the same from the nearest arm that it learnt from
  /// What predictions of the tip are off by, as far as the fit can say: what it left in its own
  /// windows, and what e's uncertainty makes of the tip in them (root of the sum of squares).
  double expected_error_m = 0.0;
};

/// Least squares with a prior that is the family's own spread, by Gauss–Newton; errors beyond a few
/// millimetres count by their length, not their square. It goes on from the best four of the
/// family's middle and some of its arms, to the lowest minimum that they lead to.
/// @throws InputError if the model is of no family, the episodes are another arm's or hold no
/// tracked window.
ArmFit fit_arm(const ArmDescription& arm, const CompensationModel& family,
               const std::vector<Episode>& episodes, int jobs = 0);

/// Whether they hold such a window.
bool can_be_fitted_to(const std::vector<Episode>& episodes);

/// How well a family does on arms that it did not learn from: each episode's arm is fitted to its
/// first kFitFrames frames, or its first half where it is shorter; the error is that of the tip
/// over the rest, in open-loop rollouts of up to 600 frames. The mean over the episodes that are
/// long enough, and in both of whose parts the arm was tracked; NaN where none is. Of an ordinary
/// model: the same without a fit.
double error_on_other_arms_m(const ArmDescription& arm, const CompensationModel& model,
                             const std::vector<Episode>& episodes, int jobs = 0);

/// Whether that is more than nothing.
bool tells_of_other_arms(const std::vector<Episode>& episodes);

inline constexpr int kFitFrames = 400;

}  // namespace limber
