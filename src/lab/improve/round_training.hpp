#pragma once

#include <string>
#include <vector>

#include "limber/lab/improve.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// The model of a round: `from`, trained further on `data`, or a new one; a prior and a new one
/// learn from all that `data` replay. Whole and ready for `plan`. Valves are those of `start`; if
/// it has none, those that the data show. The region that counts as learnt is widened, and the
/// error is measured on `data.unseen`.
/// @param start  the last round's model
/// @param from  what training goes on from: `start`, or the prior
/// @param sources  what was learnt from in this run, for the training record
/// @throws SystemFault if training diverges; Interrupted after Ctrl-C.
CompensationModel learn_round(const ImproveSettings& settings, const CompensationModel& start,
                              const CompensationModel& from, const std::string& from_hash,
                              const TrainingData& data, const std::string& sources);

/// `data` with its replayed episodes among the others: of ten one validates.
TrainingData with_replay_as_data(TrainingData data);

/// So few runs say little about an error that 95 % of runs stay below: then the larger of what was
/// known and what was measured is kept.
inline constexpr int kMinRunsForError = 19;

/// The error that a model keeps. @param known, measured  none: not known, or not measurable
std::optional<PredictionError> kept_error(const std::optional<PredictionError>& known,
                                          const std::optional<PredictionError>& measured);

}  // namespace limber
