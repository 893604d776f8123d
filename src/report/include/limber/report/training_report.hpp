#pragma once
// For those who show results.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/training/ensemble_evaluation.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

struct TrainingSpeed;

/// Keys position_error_cm and orientation_error_rad of `evaluate --json`.
nlohmann::ordered_json to_json(const TipErrors& errors);
/// A list of {name, value, sd, reference}, in the units of their names.
nlohmann::ordered_json to_json(const std::vector<TraitEstimate>& traits);
nlohmann::ordered_json to_json(const std::vector<ArmChange>& changes);
/// The object `network` of `evaluate --json`, without `open_loop_from_setpoints`.
nlohmann::ordered_json to_json(const RolloutErrors& errors);
/// The object `long_rollout` of `train` and `evaluate` with --json.
nlohmann::ordered_json to_json(const LongRollout& rollout);
/// The object of `evaluate --json`.
nlohmann::ordered_json to_json(const Evaluation& evaluation);
/// The same as a table for people.
std::string to_text(const Evaluation& evaluation);

/// What to do about a network that multiplies a tracker's noise so much; empty: it is not much.
std::string noise_warning(double noise_multiplied);

/// The object `ensemble` of `evaluate --json`.
nlohmann::ordered_json to_json(const EnsembleEvaluation& evaluation);
std::string to_text(const EnsembleEvaluation& evaluation);

/// The object `fine_tuning` of `train --json`.
nlohmann::ordered_json to_json(const FineTuningReport& report);
/// A table: tip position errors in cm.
std::string to_text(const FineTuningReport& report);

/// The object of `train --bench --json`.
nlohmann::ordered_json to_json(const TrainingSpeed& speed);
std::string to_text(const TrainingSpeed& speed);

/// Loss and validation error over epochs, as SVG text.
std::string learning_curve_svg(const std::vector<LearningCurvePoint>& curve);

}  // namespace limber
