#pragma once
// For those who train and evaluate models.

#include <optional>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// Longest run for measuring prediction errors: plans last some seconds.
inline constexpr double kLongestErrorRun_s = 5.0;

/// Error of the leading network on `unseen`, which must have been used neither for its training nor
/// for its choice. This is how good a plan's prediction is: from set points through the model's
/// valves and the network, never corrected.
///
/// A run is a motion as it was recorded, including its hold, cut after kLongestErrorRun_s. Motions
/// that move no set point do not count. If at least 19 runs begin with the arm at rest, as plans
/// do, only those count. A run starts from the measured pressures and backbone of its first frame,
/// which is tracked; the valves know the set points before it. Without a valve model, set points
/// count as pressures, as in plans. If the recording holds no set points of its own, measured
/// pressures are used. Untracked frames don't count; a run ends with its last tracked frame. None
/// if there is no run, or a prediction is not finite. The same for any `jobs`.
/// @param first  frame, counted through all episodes, before which no run begins: what is before it
///               only says how the arm moves there, and what its valves do
std::optional<PredictionError> measure_prediction_error(const ArmDescription& arm,
                                                        const CompensationModel& model,
                                                        const std::vector<Episode>& unseen,
                                                        int jobs = 0, int first = 0);

/// What a model has learnt that was trained on `data`, for CompensationModel::learnt: of its
/// training and its replayed episodes, and the region of the model that it started from.
/// @param start  of the model that was fine-tuned; null: none
LearntRegion learnt_region_of(const TrainingData& data, const LearntRegion* start = nullptr);

/// Measures the error of a finished model and stores it (none if it can't be measured). Also widens
/// the region that the model stores as learnt, if any, by its own predictions along the same runs:
/// networks predict shapes that are a little off those of an arm, and such shapes should not count
/// as beyond the region.
void note_unseen(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& unseen, int jobs = 0);

/// The second half of that alone, along whole episodes of any recording of the arm.
void note_shapes(const ArmDescription& arm, CompensationModel& model,
                 const std::vector<Episode>& episodes, int jobs = 0);

}  // namespace limber
