#pragma once
// For those who train and evaluate models.

#include <optional>
#include <string>
#include <vector>

#include "limber/training/evaluation.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// The settings for training a trained model further: those of `preset` with its last stage alone,
/// because the model knows already what short windows teach, and with half of that stage's epochs
/// and a tenth of the rate, so that nothing learnt is lost first (docs/training.md has the
/// figures). Adam in place of SOAP, no decay, all frames of a window alike.
TrainingSettings fine_tuning_of(TrainingSettings preset);

/// Errors of a model before and after tuning, on episodes that neither run was trained on. The
/// errors on the new data chose the best epoch, so only a test recording gives certainty
/// (`evaluate`).
struct FineTuningReport {
  struct Change {
    RolloutErrors before;
    RolloutErrors after;
  };
  std::optional<Change> new_data;
  std::optional<Change> old_data;
};

/// For an ensemble, the first members are compared. Empty or too short recordings are left out.
FineTuningReport compare_models(const ArmDescription& arm, const CompensationModel& before,
                                const CompensationModel& after,
                                const std::vector<Episode>& new_data,
                                const std::vector<Episode>& old_data, int jobs);

}  // namespace limber
