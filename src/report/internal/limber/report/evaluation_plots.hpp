#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/forward/forward_model.hpp"

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
std::vector<std::filesystem::path> evaluation_plot_paths(const std::filesystem::path& folder,
                                                         Dimension dimension);

/// Writes those, in that order; returns their paths.
std::vector<std::filesystem::path> write_evaluation_plots(const std::filesystem::path& folder,
                                                          const EvaluationPlots& plots);

/// The paper's Fig. 1: the arm at the end of `episode` (its right side inflated fully, then
/// vented), compared with what both models say.
std::string plot_inflate_deflate(const ForwardModel& no_load, const ForwardModel* network,
                                 const Episode& episode);

}  // namespace limber
