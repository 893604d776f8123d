#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/network/prediction_error.hpp"
#include "open_loop_error.hpp"
#include "plan_runs.hpp"
#include "stopping_rule.hpp"

namespace limber {

/// What became of the plans of one batch; distances over those that were executed to their end,
/// including those that collided.
struct PlanFigures {
  int environments = 0;
  int solved = 0;
  int executed = 0;
  int collided = 0;
  int arrived = 0;
  std::optional<double> mean_m;            ///< none where nothing was executed
  std::optional<double> standard_error_m;  ///< of the mean; none with fewer than two
  std::optional<double> median_m;
};
PlanFigures figures_of(const std::vector<PlanRun>& runs);

EndDistances end_distances(const std::vector<PlanRun>& runs);

/// A round's model, judged. Round 0 is the model to start from.
struct RoundFigures {
  int round = 0;
  std::string model_hash;
  std::optional<PredictionError> prediction_error;  ///< as the model stores it
  double learning_min = 0.0;                        ///< arm time of everything learnt from so far
  int learning_ventings = 0;  ///< before the runs learnt from; they take time that is not recorded
  double judging_min = 0.0;   ///< arm time of selections and reported runs so far
  PlanFigures selection;
  EndDistances selection_m;
  PlanFigures reported;
  OpenLoopError on_plans;    ///< on the reported runs
  OpenLoopError on_motions;  ///< on fresh random motions

  /// None if either is 0.
  std::optional<double> mean_error_ratio() const;
  std::optional<double> largest_error_ratio() const;
};

/// round_K/round.json, and an element of the summary's `rounds`.
nlohmann::ordered_json to_json(const RoundFigures& figures);
/// One line for people.
std::string to_text(const RoundFigures& figures);

/// summary.json.
nlohmann::ordered_json improve_summary(const ImproveSettings& settings,
                                       const std::vector<RoundFigures>& rounds,
                                       const RoundChoice& choice);
/// Distance over arm time, as SVG.
std::string improve_curve(const std::vector<RoundFigures>& rounds, const RoundChoice& choice);
/// report.html.
std::string improve_report(const ImproveSettings& settings, const std::vector<RoundFigures>& rounds,
                           const RoundChoice& choice);

}  // namespace limber
