#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/training/yardsticks.hpp"

namespace limber {

/// Pictures of an evaluation, as SVG text. `network` may be null.
struct EvaluationPlots {
  std::string error_over_time;           ///< open loop, both models
  std::string position_distribution;     ///< the paper's Fig. 4, position
  std::string orientation_distribution;  ///< the paper's Fig. 4, orientation
  std::string backbones;                 ///< a few frames, recorded and predicted
  std::string shapes;                    ///< HTML (shapes_page.hpp); empty of an arm in the plane
};

EvaluationPlots plot_evaluation(const ArmDescription& arm, const ForwardModel& no_load,
                                const ForwardModel* network, const std::vector<Episode>& episodes,
                                int jobs = 0);

/// error_over_time.svg, position_distribution.svg, orientation_distribution.svg and backbones.svg;
/// in space shapes.html, too.
std::vector<fs::path> evaluation_plot_paths(const fs::path& folder, Dimension dimension);

/// Writes those, in that order; returns their paths.
std::vector<fs::path> write_evaluation_plots(const fs::path& folder, const EvaluationPlots& plots);

/// The paper's Fig. 1: the arm at the end of `episode` (its right side inflated fully, then
/// vented), compared with what both models say.
std::string plot_inflate_deflate(const ForwardModel& no_load, const ForwardModel* network,
                                 const Episode& episode);

/// What `evaluate --json` says of yardsticks, horizons and episodes: `baselines.NAME` at every
/// horizon, `horizons`, `episodes`, `frames_counted`, `yardsticks_fitted_to`.
Json to_json(const YardstickReport& report, const std::vector<Episode>& episodes);

/// Tables for people: all yardsticks, the worst episodes, and which frames count.
std::string to_text(const YardstickReport& report);

/// Mean tip error over the frames between restarts, from one to the whole episode, as SVG text.
std::string error_over_horizon_svg(const YardstickReport& report);

/// Writes one_step.csv, window_32.csv, per_motion.csv and open_loop.csv: a row for each frame, its
/// episode, frame, time and whether it was tracked, and of each plate what was recorded and what
/// the models predict. A cell is empty where nothing is predicted. Returns their paths.
std::vector<fs::path> write_predictions(const fs::path& folder, const ForwardModel& no_load,
                                        const ForwardModel* network,
                                        const std::vector<Episode>& episodes, int jobs);
std::vector<fs::path> prediction_paths(const fs::path& folder);

}  // namespace limber
