#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/tube_runs.hpp"

namespace limber {

/// Budget of each plan of a calibration, where none is asked for.
inline constexpr std::uint64_t kCalibrationQueries = 20'000;

struct CalibrationSettings {
  TubeRunSettings runs;
  fs::path model_file;
  fs::path folder;  ///< of finished runs and the evidence
  std::vector<double> levels = {0.90, 0.95};
  double confidence = 0.95;  ///< of every level that is promised, in (0, 1)
  int scale_runs = 500;
  int screen_runs = 500;
  int test_runs = 4000;
  int audit_runs = 4000;
  bool resume = false;
  bool force = false;
  std::function<void(const std::string&)> say = [](const std::string&) {};
};

/// So few environments have a plan that nothing can be calibrated.
class TooFewPlans : public InputError {
 public:
  using InputError::InputError;
};

struct CalibrationResult {
  /// Carries the tube, with every level that passed its test; none if none did.
  CompensationModel model;
  Json evidence;
  std::vector<std::string> failures;  ///< a sentence for each level that failed test or audit
};

/// Test runs that can show the highest of the levels, if none of them is outside.
int min_test_runs(const CalibrationSettings& settings);

/// Refuses levels, confidence and numbers of runs that can't give what is asked for.
/// @throws InputError
void require_usable(const CalibrationSettings& settings);

/// Of both kinds of calibration. @throws InputError
void require_usable_levels(const std::vector<double>& levels, double confidence);

/// docs/tube.md, Calibration: a shape, a screen that says which factors to test on plans made with
/// them, tests and an audit, each in environments of its own. Writes evidence.json and
/// evidence.html into the folder. @throws TooFewPlans
CalibrationResult calibrate_tube(const CalibrationSettings& settings);

/// A tube from plans and the runs that executed them, with what they can promise (docs/tube.md).
/// @param recordings  one per plan, in the same order
/// @throws InputError if a recording is not its plan's, two are the same, or there are too few for
/// a level, naming the largest level that they can promise.
struct RecordedCalibration {
  ArmDescription arm;
  CompensationModel model;
  std::string model_hash;
  std::vector<fs::path> plans;
  std::vector<fs::path> recordings;
  std::vector<double> levels = {0.90, 0.95};
  double confidence = 0.95;
};
Tube tube_from_recordings(const RecordedCalibration& settings);

}  // namespace limber
