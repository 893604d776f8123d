#pragma once
// For those who plan.

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/backbone.hpp"

namespace limber {

class YamlReader;

/// How far predictions were from the arm on motions used neither for training nor for choosing the
/// model. Predictions are open loop from set points, through the model's valves and its (leading)
/// network, in runs that start from measured states (docs/training.md).
struct PredictionError {
  int runs = 0;        ///< number of runs, ≥ 1
  double run_s = 0.0;  ///< their mean length, > 0
  // Of fewer than kMinRuns, what follows is a multiple of their median that is usual for 95 %.
  /// The largest distance of any plate in any frame of a run: kShare of the runs do not exceed it.
  double max_position_m = 0.0;
  /// The farthest that the arm came off the predicted path in a run, early or late: the clearance
  /// that the motion would have needed. At most the above.
  double off_path_m = 0.0;
  double end_position_m = 0.0;  ///< the same of the tip's distance at the run's end
  /// The same of the tip's heading at the run's end; none where rotations were not measured, which
  /// is in space alone.
  std::optional<double> end_orientation_rad = 0.0;
  static constexpr double kShare = 0.95;
  static constexpr int kMinRuns = 19;  ///< the largest of 19 is 95 %
  bool operator==(const PredictionError&) const = default;
};

/// What was found for one share of runs: `factor` times the scales hold them.
struct TubeLevel {
  double level = 0.0;   ///< share of runs that stay in the tube, in (0, 1)
  double factor = 0.0;  ///< > 0
  int runs = 0;         ///< runs that were planned with this tube and tested it; 0: not tested yet
  int outside = 0;      ///< of them
  double confidence = 0.0;  ///< that no more than 1 − level of all runs leave the tube, in (0, 1)
  int audit_runs = 0;       ///< runs in environments used for nothing else
  int audit_outside = 0;
  bool operator==(const TubeLevel&) const = default;
};

/// How far the true backbone may be from the predicted one, over a whole motion (docs/tube.md): a
/// shape, and a factor for each share of runs. `limber calibrate` measures both.
struct Tube {
  std::vector<double> plate_scale_m;   ///< one per plate, base first, > 0
  double end_scale_m = 0.0;            ///< of the tip after the hold, > 0
  double end_heading_scale_rad = 0.0;  ///< > 0
  RoomGrowth growth;                   ///< of the scales of plates, from where they start
  std::string source;                  ///< "virtual arm", or what the recordings say
  std::vector<TubeLevel> levels;       ///< rising levels, at least one

  /// The tube of a level, in metres, of plate i where it is `moved_m` from where it started.
  double radius_m(const TubeLevel& level, std::size_t plate, double moved_m) const {
    return level.factor * plate_scale_m[plate] * growth.share_after(moved_m);
  }

  static constexpr double kDefaultLevel = 0.95;
  /// None if it holds no such level.
  const TubeLevel* find(double level) const;
  /// kDefaultLevel, or the highest one below it, or the lowest.
  const TubeLevel& default_level() const;
  bool operator==(const Tube&) const = default;
};

/// The bound that the next value stays below with probability `share`, if it is sampled as `values`
/// were (split conformal): the ⌈(n + 1)·share⌉-th smallest of n, or the largest if there are too
/// few.
/// @pre values not empty; 0 < share < 1
double conformal_quantile(std::vector<double> values, double share = PredictionError::kShare);

/// @throws InputError beginning with `where` and naming the number that is out of range.
void validate(const PredictionError& error, const std::string& where);

void validate(const Tube& tube, const std::string& where);

/// The text of a model's metadata key `tube` (docs/formats.md); numbers survive the round trip.
std::string tube_to_metadata(const Tube& tube);
/// @throws InputError naming the key.
Tube read_tube(const YamlReader& root);
/// The object `tube` of inspect --json.
nlohmann::ordered_json to_json(const Tube& tube);
/// One line per level, for people.
std::string to_text(const Tube& tube);
/// "0.9, 0.95".
std::string names_of_levels(const Tube& tube);

/// The text of a model's metadata key `prediction_error` (docs/formats.md); numbers survive the
/// round trip exactly.
std::string prediction_error_to_metadata(const PredictionError& error);
/// @throws InputError naming the key.
PredictionError read_prediction_error(const YamlReader& root);

/// The object `prediction_error` of train, inspect and evaluate with --json.
nlohmann::ordered_json to_json(const PredictionError& error);
/// One line for people.
std::string to_text(const PredictionError& error);

}  // namespace limber
