#pragma once
// For those who plan.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace limber {

class YamlReader;

/// How far predictions were from the arm on motions used neither for training nor for choosing the
/// model. Predictions are open loop from set points, through the model's valves and its (leading)
/// network, in runs that start from measured states (docs/training.md).
struct PredictionError {
  int runs = 0;        ///< number of runs, ≥ 1
  double run_s = 0.0;  ///< their mean length, > 0
  /// The largest distance of any plate in any frame of a run: kShare of the runs do not exceed it.
  double max_position_m = 0.0;
  /// The farthest that the arm came off the predicted path in a run, early or late: the clearance
  /// that the motion would have needed. At most the above.
  double off_path_m = 0.0;
  double end_position_m = 0.0;       ///< the same of the tip's distance at the run's end
  double end_orientation_rad = 0.0;  ///< the same of the tip's heading at the run's end
  static constexpr double kShare = 0.95;
  bool operator==(const PredictionError&) const = default;
};

/// The bound that the next value stays below with probability `share`, if it is sampled as `values`
/// were (split conformal): the ⌈(n + 1)·share⌉-th smallest of n, or the largest if there are too
/// few.
/// @pre values not empty; 0 < share < 1
double conformal_quantile(std::vector<double> values, double share = PredictionError::kShare);

/// @throws InputError beginning with `where` and naming the number that is out of range.
void validate(const PredictionError& error, const std::string& where);

/// The text of a model's metadata key `prediction_error` (docs/formats.md); numbers survive the
/// round trip exactly.
std::string prediction_error_to_metadata(const PredictionError& error);
/// @throws InputError naming the key.
PredictionError read_prediction_error(const YamlReader& root);

/// The object `prediction_error` of train, inspect and evaluate with --json.
nlohmann::ordered_json to_json(const PredictionError& error);
/// One line for people.
std::string prediction_error_to_text(const PredictionError& error);

}  // namespace limber
