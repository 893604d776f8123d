#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/forward/forward_model.hpp"
#include "limber/training/yardsticks.hpp"

namespace limber {

/// What `evaluate --json` says of yardsticks, horizons and episodes: `baselines.NAME` at every
/// horizon, `horizons`, `episodes`, `frames_counted`, `yardsticks_fitted_to`.
nlohmann::ordered_json to_json(const YardstickReport& report, const std::vector<Episode>& episodes);

/// Tables for people: all yardsticks, the worst episodes, and which frames count.
std::string to_text(const YardstickReport& report);

/// Mean tip error over the frames between restarts, from one to the whole episode, as SVG text.
std::string error_over_horizon_svg(const YardstickReport& report);

/// Which frames an error is a mean over, in words.
std::string frames_counted_in_words();

/// Writes one_step.csv, window_32.csv, per_motion.csv and open_loop.csv: a row for each frame, its
/// episode, frame, time and whether it was tracked, and of each plate what was recorded and what
/// the models predict. A cell is empty where nothing is predicted. Returns their paths.
std::vector<std::filesystem::path> write_predictions(const std::filesystem::path& folder,
                                                     const ForwardModel& no_load,
                                                     const ForwardModel* network,
                                                     const std::vector<Episode>& episodes,
                                                     int jobs);
std::vector<std::filesystem::path> prediction_paths(const std::filesystem::path& folder);

}  // namespace limber
