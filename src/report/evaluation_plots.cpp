#include "limber/report/evaluation_plots.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/plot/chart.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/shapes_page.hpp"
#include "limber/training/evaluation.hpp"

namespace limber {

namespace {

constexpr int kShownFrames = 6;

SeriesStyle style_of(int color, bool dashed = false) {
  SeriesStyle style;
  style.color = palette_color(color);
  style.dashed = dashed;
  return style;
}

struct Predictions {
  FrameMatrix no_load;
  std::optional<FrameMatrix> network;
};

Predictions predict_both(const ForwardModel& no_load, const ForwardModel* network,
                         const Episode& episode, int jobs) {
  Predictions predictions{predict(no_load, episode, Restart::every_frame, jobs), std::nullopt};
  if (network != nullptr) {
    predictions.network = predict(*network, episode, Restart::at_the_start_only, jobs);
  }
  return predictions;
}

/// Over x, number `across` of each pose: 1, y, or in space 2, z.
void draw_backbone(Chart& chart, const char* label, const FrameMatrix& backbones,
                   Dimension dimension, Eigen::Index across, Eigen::Index t,
                   const SeriesStyle& style) {
  std::vector<double> x;
  std::vector<double> y;
  for (Eigen::Index i = 0; i < backbones.cols(); i += pose_size(dimension)) {
    x.push_back(backbones(t, i));
    y.push_back(backbones(t, i + across));
  }
  SeriesStyle dots = style;
  dots.radius_px = 2.0;
  chart.line(label, x, y, style).points("", x, y, dots);
}

Chart backbone_chart(const std::string& title, const Predictions& predictions,
                     const Episode& episode, Eigen::Index t, Eigen::Index across = 1) {
  Chart chart(title);
  chart.x_axis("x [m]").y_axis(across == 1 ? "y [m]" : "z [m]").equal_aspect();
  const auto draw = [&](const char* label, const FrameMatrix& poses, const SeriesStyle& style) {
    draw_backbone(chart, label, poses, episode.dimension, across, t, style);
  };
  draw("recorded", episode.backbone, style_of(kTrueArmColor));
  draw("no load", predictions.no_load, style_of(kNoLoadColor, true));
  if (predictions.network) {
    draw("network", *predictions.network, style_of(kNetworkColor));
  }
  return chart;
}

/// Frames spread evenly over the episode, each the last of its motion: where the arm has settled.
std::vector<Eigen::Index> shown_frames(const Episode& episode) {
  std::vector<Eigen::Index> ends;
  const auto& motion = episode.motion_index;
  for (std::size_t t = 1; t < motion.size(); ++t) {
    if (t + 1 == motion.size() || motion[t + 1] != motion[t]) {
      ends.push_back(static_cast<Eigen::Index>(t));
    }
  }
  std::vector<Eigen::Index> shown;
  const auto count = std::min(static_cast<int>(ends.size()), kShownFrames);
  for (int k = 0; k < count; ++k) {
    const std::size_t at =
        (2 * static_cast<std::size_t>(k) + 1) * ends.size() / (2 * static_cast<std::size_t>(count));
    shown.push_back(ends[at]);
  }
  return shown;
}

std::string error_over_time(const Predictions& predictions, const Episode& episode) {
  std::vector<double> time_s(episode.time_s.begin() + 1, episode.time_s.end());
  const auto errors_cm = [&](const FrameMatrix& predicted) {
    return tip_errors(predicted, episode, 1).position_cm;
  };
  Chart chart("Tip error over time, open loop");
  chart.x_axis("time [s]").y_axis("position error [cm]").size_px(900, 360);
  chart.note("The network starts from the first recorded backbone and is never corrected.");
  SeriesStyle thin = style_of(kNoLoadColor);
  thin.width_px = 1.0;
  chart.line("no load", time_s, errors_cm(predictions.no_load), thin);
  if (predictions.network) {
    thin.color = palette_color(kNetworkColor);
    chart.line("network", time_s, errors_cm(*predictions.network), thin);
  }
  return chart.svg();
}

std::string turned_shapes(const ArmDescription& arm, const Predictions& predictions,
                          const Episode& episode, const std::string& still) {
  std::vector<ShownShapes> predicted = {{"no load", "--simple", &predictions.no_load}};
  if (predictions.network) {
    predicted.push_back({"network, open loop", "--network", &*predictions.network});
  }
  return shapes_page(fmt::format("{}: recorded and predicted", arm.name), arm, episode, predicted,
                     still);
}

const Episode& longest(const std::vector<Episode>& episodes) {
  return *std::ranges::max_element(episodes, {}, &Episode::frame_count);
}

}  // namespace

EvaluationPlots plot_evaluation(const ArmDescription& arm, const ForwardModel& no_load,
                                const ForwardModel* network, const std::vector<Episode>& episodes,
                                int jobs) {
  TipErrorSeries no_load_errors;
  TipErrorSeries network_errors;
  for (const Episode& episode : episodes) {
    const Predictions predictions = predict_both(no_load, network, episode, jobs);
    append(no_load_errors, tip_errors(predictions.no_load, episode, 1));
    if (predictions.network) {
      append(network_errors, tip_errors(*predictions.network, episode, 1));
    }
  }
  Chart position("Position error of the tip, open loop");
  Chart orientation("Orientation error of the tip, open loop");
  position.y_axis("position error [cm]").without_legend();
  orientation.y_axis("orientation error [rad]").without_legend();
  position.distribution("no load", no_load_errors.position_cm, style_of(kNoLoadColor));
  if (network != nullptr) {
    position.distribution("network", network_errors.position_cm, style_of(kNetworkColor));
  }
  if (!episodes.front().lifted) {
    orientation.distribution("no load", no_load_errors.orientation_rad, style_of(kNoLoadColor));
  }
  if (network != nullptr && !episodes.front().lifted) {
    orientation.distribution("network", network_errors.orientation_rad, style_of(kNetworkColor));
  }
  const Episode& shown = longest(episodes);
  const Predictions predictions = predict_both(no_load, network, shown, jobs);
  ChartGrid backbones(3, "Backbones at the ends of motions, open loop");
  for (const Eigen::Index across : {1, 2}) {
    if (across < position_size(shown.dimension)) {
      for (const Eigen::Index t : shown_frames(shown)) {
        backbones.add(backbone_chart(fmt::format("t = {:.1f} s", shown.time_s[t]), predictions,
                                     shown, t, across));
      }
    }
  }
  return {error_over_time(predictions, shown), position.svg(), orientation.svg(), backbones.svg(),
          arm.is_spatial() ? turned_shapes(arm, predictions, shown, backbones.svg()) : ""};
}

std::vector<std::filesystem::path> evaluation_plot_paths(const std::filesystem::path& folder,
                                                         Dimension dimension) {
  std::vector<std::filesystem::path> paths = {
      folder / "error_over_time.svg", folder / "position_distribution.svg",
      folder / "orientation_distribution.svg", folder / "backbones.svg"};
  if (dimension == Dimension::space) {
    paths.push_back(folder / "shapes.html");
  }
  return paths;
}

std::vector<std::filesystem::path> write_evaluation_plots(const std::filesystem::path& folder,
                                                          const EvaluationPlots& plots) {
  const std::vector<std::filesystem::path> paths =
      evaluation_plot_paths(folder, plots.shapes.empty() ? Dimension::plane : Dimension::space);
  write_file_atomically(paths[0], plots.error_over_time);
  write_file_atomically(paths[1], plots.position_distribution);
  write_file_atomically(paths[2], plots.orientation_distribution);
  write_file_atomically(paths[3], plots.backbones);
  if (!plots.shapes.empty()) {
    write_file_atomically(paths[4], plots.shapes);
  }
  return paths;
}

std::string plot_inflate_deflate(const ForwardModel& no_load, const ForwardModel* network,
                                 const Episode& episode) {
  const Predictions predictions = predict_both(no_load, network, episode, 1);
  Chart chart = backbone_chart("Right side inflated fully, then vented", predictions, episode,
                               episode.backbone.rows() - 1);
  chart.note("Friction keeps the arm from coming back to straight; the no-load model has none.");
  return chart.svg();
}

}  // namespace limber
