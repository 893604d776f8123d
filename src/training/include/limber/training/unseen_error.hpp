#pragma once
// For those who train and evaluate models.

#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// Longest run that prediction errors are measured over: plans last some seconds.
inline constexpr double kLongestErrorRun_s = 5.0;

/// Error of the leading network on `unseen`, which must neither have trained nor chosen it: what a
/// plan's prediction is worth, from set points through the model's valves and the network, never
/// corrected.
///
/// A run is a motion as it was recorded, its hold included, cut where it is longer than
/// kLongestErrorRun_s; what moves no set point does not count, and where there are 19 that begin
/// with the arm at rest, as plans do, only those count. It starts from the measured pressures and
/// backbone of its first frame, in which the arm was seen; set points of before it are known to the
/// valves. Where no valves are known, set points count as pressures, as in plans; where the
/// recording holds no set points of its own, measured pressures are used. Frames in which the arm
/// was not seen don't count; a run ends with the last one in which it was. None if there is no
/// run, or a prediction is not finite. The same for any `jobs`.
std::optional<PredictionError> measure_prediction_error(const ArmDescription& arm,
                                                        const CompensationModel& model,
                                                        const std::vector<Episode>& unseen,
                                                        int jobs = 0);

/// Measures the error of a finished model and stores it (none if it can't be measured), and
/// widens what the model counts as learnt, where it says so, by its own predictions along the same
/// runs: networks draw shapes that are a little off those of an arm, and whoever asks about
/// predicted shapes should not be told of that.
void note_unseen(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& unseen, int jobs = 0);

}  // namespace limber
