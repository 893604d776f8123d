#pragma once
// For those who train and evaluate models.

#include <optional>
#include <string>
#include <vector>

#include "limber/training/evaluation.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// The settings with which a model that has learnt already is trained on: those of `preset` with
/// its last stage alone, since what short windows teach is known, half of that stage's epochs and a
/// tenth of the rate, so that it is not first thrown away (docs/training.md has the figures).
TrainingSettings fine_tuning_of(TrainingSettings preset);

/// Errors of a model before and after it was tuned, on episodes that neither run learnt from. Those
/// of the new data chose the best epoch: a test recording is needed to be sure (`evaluate`).
struct FineTuningReport {
  struct Change {
    RolloutErrors before;
    RolloutErrors after;
  };
  std::optional<Change> new_data;
  std::optional<Change> old_data;
};

/// Of an ensemble, the first members are compared. Empty or too short recordings are left out.
FineTuningReport compare_models(const ArmDescription& arm, const CompensationModel& before,
                                const CompensationModel& after,
                                const std::vector<Episode>& new_data,
                                const std::vector<Episode>& old_data, int jobs);

}  // namespace limber
