#include "limber/report/evaluation_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/pose_columns.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/mapped.hpp"
#include "limber/plot/chart.hpp"
#include "limber/plot/svg_drawing.hpp"
#include "limber/report/shapes_page.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/evaluation.hpp"

namespace limber {

namespace {

constexpr int kShownFrames = 6;

/// Of an episode. @param network  null where there is none
struct Predictions {
  const FrameMatrix& no_load;
  const FrameMatrix* network;
};

/// Over x, number `across` of each pose: 1, y, or in space 2, z.
void draw_backbone(Chart& chart, const char* label, const FrameMatrix& backbones,
                   Dimension dimension, Eigen::Index across, Eigen::Index t,
                   const SeriesStyle& style) {
  std::vector<double> x, y;
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
  draw("recorded", episode.backbone, {.color = palette_color(kTrueArmColor)});
  draw("no load", predictions.no_load, {.color = palette_color(kNoLoadColor), .dashed = true});
  if (predictions.network) {
    draw("network", *predictions.network, {.color = palette_color(kNetworkColor)});
  }
  return chart;
}

/// Frames spread evenly over the episode, each the last of its motion: where the arm has settled.
std::vector<Eigen::Index> shown_frames(const Episode& episode) {
  std::vector<Eigen::Index> ends;
  const auto& motion = episode.motion_index;
  for (std::size_t t = 1; t < motion.size(); ++t) {
    if (t + 1 == motion.size() || motion[t + 1] != motion[t]) {
      ends.push_back(Eigen::Index(t));
    }
  }
  std::vector<Eigen::Index> shown;
  const auto count = std::min(int(ends.size()), kShownFrames);
  for (int k = 0; k < count; ++k) {
    const std::size_t at = (2 * std::size_t(k) + 1) * ends.size() / (2 * std::size_t(count));
    shown.push_back(ends[at]);
  }
  return shown;
}

std::string error_over_time(const Predictions& predictions, const Episode& episode) {
  std::vector<double> time_s(episode.time_s.begin() + 1, episode.time_s.end());
  const auto errors_cm = [&](const FrameMatrix& predicted) {
    return tip_errors(predicted, episode).position_cm;
  };
  Chart chart("Tip error over time, open loop");
  chart.x_axis("time [s]").y_axis("position error [cm]").size_px(900, 360);
  chart.note("The network starts from the first recorded backbone and is never corrected.");
  SeriesStyle thin{.color = palette_color(kNoLoadColor), .width_px = 1.0};
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

constexpr std::size_t kShownEpisodes = 3;

/// Which frames an error is a mean over.
constexpr const char* kFramesCounted =
    "every frame after the first of its episode in which the arm was tracked; a frame that a "
    "rollout was given as its start is no prediction, and one that rests on no tracked frame "
    "counts for nothing";

constexpr std::array<std::pair<const char*, Restart>, 4> kHorizons = {
    {{"one_step", Restart::every_frame},
     {"window_32", Restart::every_32_frames},
     {"per_motion", Restart::every_motion},
     {"open_loop", Restart::at_the_start_only}}};

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{:>11.2f}", value) : fmt::format("{:>11}", "-");
}

std::string yardstick_row(const std::string& label, const RolloutErrors& errors) {
  std::string text = fmt::format("{:<26}", label);
  for (const TipErrors& one :
       {errors.one_step, errors.window_32, errors.per_motion, errors.open_loop}) {
    text += cell(one.position_cm.mean);
  }
  return text + cell(errors.open_loop.plates_cm.mean) + "\n";
}

/// Of the curve that has the best right to be trusted: the network's, or the no-load model's.
std::string worst_episodes(const YardstickReport& report) {
  const auto network = std::ranges::find(report.predictors, "network", &PredictorErrors::key);
  const PredictorErrors& shown =
      network != report.predictors.end() ? *network : report.predictors.front();
  std::vector<std::size_t> order(shown.episode_cm.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t i) { return std::isnan(shown.episode_cm[i]); });
  std::ranges::stable_sort(order, std::greater{},
                           [&](std::size_t i) { return shown.episode_cm[i]; });
  std::string text = fmt::format("worst episodes, {} open loop [cm]:", shown.label);
  for (std::size_t k = 0; k < std::min(kShownEpisodes, order.size()); ++k) {
    text += fmt::format("{} {} {:.2f}", k == 0 ? "" : ",", report.episode_names[order[k]],
                        shown.episode_cm[order[k]]);
  }
  return text + fmt::format(" (of {})\n", order.size());
}

std::string poses_header(const std::string& name, const Episode& episode) {
  std::string text;
  for (int p = 0; p < episode.point_count(); ++p) {
    for (const auto& [key, unit] : pose_columns(episode.dimension)) {
      text += fmt::format(",{}_{}{}{}", name, key, p, unit);
    }
  }
  return text;
}

std::string pose_cells(const FrameMatrix& poses, Eigen::Index t) {
  std::string text;
  for (const float value : poses.row(t)) {
    text += std::isfinite(value) ? fmt::format(",{:.6f}", value) : std::string(",");
  }
  return text;
}

/// @param network  one for each episode, or none
std::string predictions_csv(const std::vector<Episode>& episodes,
                            const std::vector<FrameMatrix>& no_load,
                            const std::vector<FrameMatrix>& network) {
  const Episode& first = episodes.front();
  std::string text = "episode,frame,time_s,tracked" + poses_header("recorded", first) +
                     poses_header("no_load", first) +
                     (network.empty() ? "" : poses_header("network", first)) + "\n";
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    for (int t = 0; t < episodes[e].frame_count(); ++t) {
      text += fmt::format("{},{},{:.6f},{}", e, t, episodes[e].time_s[t],
                          episodes[e].was_tracked(t) ? 1 : 0);
      text += pose_cells(episodes[e].backbone, t) + pose_cells(no_load[e], t);
      text += (network.empty() ? "" : pose_cells(network[e], t)) + "\n";
    }
  }
  return text;
}

}  // namespace

EvaluationPlots plot_evaluation(const ArmDescription& arm, const ForwardModel& no_load,
                                const ForwardModel* network, const std::vector<Episode>& episodes,
                                int jobs) {
  const std::vector<FrameMatrix> by_no_load =
      predict(no_load, episodes, Restart::every_frame, jobs);
  const std::vector<FrameMatrix> by_network =
      network == nullptr ? std::vector<FrameMatrix>()
                         : predict(*network, episodes, Restart::at_the_start_only, jobs);
  const auto errors_of = [&](const std::vector<FrameMatrix>& predicted) {
    TipErrorSeries errors;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
      append(errors, tip_errors(predicted[i], episodes[i]));
    }
    return errors;
  };
  Chart position("Position error of the tip, open loop");
  Chart orientation("Orientation error of the tip, open loop");
  position.y_axis("position error [cm]").without_legend();
  orientation.y_axis("orientation error [rad]").without_legend();
  const auto add = [&](const char* name, const TipErrorSeries& errors, int color) {
    position.distribution(name, errors.position_cm, {.color = palette_color(color)});
    if (!episodes.front().lifted) {
      orientation.distribution(name, errors.orientation_rad, {.color = palette_color(color)});
    }
  };
  add("no load", errors_of(by_no_load), kNoLoadColor);
  if (network != nullptr) {
    add("network", errors_of(by_network), kNetworkColor);
  }
  const Episode& shown = longest(episodes);
  const auto index = std::size_t(&shown - episodes.data());
  const Predictions predictions{by_no_load[index],
                                network == nullptr ? nullptr : &by_network[index]};
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

std::vector<fs::path> evaluation_plot_paths(const fs::path& folder, Dimension dimension) {
  std::vector<fs::path> paths = {folder / "error_over_time.svg",
                                 folder / "position_distribution.svg",
                                 folder / "orientation_distribution.svg", folder / "backbones.svg"};
  if (dimension == Dimension::space) {
    paths.push_back(folder / "shapes.html");
  }
  return paths;
}

std::vector<fs::path> write_evaluation_plots(const fs::path& folder, const EvaluationPlots& plots) {
  const std::vector<fs::path> paths =
      evaluation_plot_paths(folder, plots.shapes.empty() ? Dimension::plane : Dimension::space);
  const std::string* const texts[] = {&plots.error_over_time, &plots.position_distribution,
                                      &plots.orientation_distribution, &plots.backbones,
                                      &plots.shapes};
  for (std::size_t i = 0; i < paths.size(); ++i) {
    write_file_atomically(paths[i], *texts[i]);
  }
  return paths;
}

std::string plot_inflate_deflate(const ForwardModel& no_load, const ForwardModel* network,
                                 const Episode& episode) {
  const FrameMatrix by_no_load = predict(no_load, episode, Restart::every_frame, 1);
  const FrameMatrix by_network = network == nullptr
                                     ? FrameMatrix()
                                     : predict(*network, episode, Restart::at_the_start_only, 1);
  const Predictions predictions{by_no_load, network == nullptr ? nullptr : &by_network};
  Chart chart = backbone_chart("Right side inflated fully, then vented", predictions, episode,
                               episode.backbone.rows() - 1);
  chart.note("Friction keeps the arm from coming back to straight; the no-load model has none.");
  return chart.svg();
}

Json to_json(const YardstickReport& report, const std::vector<Episode>& episodes) {
  Json json;
  json["yardsticks_fitted_to"] = report.fitted_to;
  json["frames_counted"] = kFramesCounted;
  json["horizons"]["frames"] = report.horizon_frames;
  json["episodes"] = Json::array();
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    json["episodes"].push_back(
        {{"name", report.episode_names[e]},
         {"frames", episodes[e].frame_count()},
         {"tracked", episodes[e].frame_count() - episodes[e].untracked_count()}});
  }
  for (const PredictorErrors& curve : report.predictors) {
    if (curve.errors) {
      json["baselines"][curve.key] = to_json(*curve.errors);
    }
    Json& horizon = json["horizons"]["tip_error_cm"][curve.key];
    for (const double value : curve.tip_cm) {
      horizon.push_back(json_number(value));
    }
    for (std::size_t e = 0; e < curve.episode_cm.size(); ++e) {
      json["episodes"][e]["tip_error_cm"][curve.key] = json_number(curve.episode_cm[e]);
    }
  }
  return json;
}

std::string to_text(const YardstickReport& report) {
  std::string text =
      fmt::format("{:<26}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "yardsticks, mean tip [cm]", "one step",
                  "32 frames", "per motion", "open loop", "all plates");
  for (const PredictorErrors& predictor : report.predictors) {
    text += predictor.errors ? yardstick_row(predictor.label, *predictor.errors) : "";
  }
  text += "all plates: open loop, mean over all plates but the base. Fitted to " +
          report.fitted_to + "\n";
  return text + worst_episodes(report) + "counted: " + kFramesCounted + "\n";
}

std::string error_over_horizon_svg(const YardstickReport& report) {
  Chart chart("Tip error over the horizon");
  chart.x_axis("frames between restarts, log2 (0: one frame; right end: whole episode)")
      .y_axis("mean position error [cm]")
      .size_px(900, 420)
      .logarithmic_y();
  const auto x = mapped<double>(report.horizon_frames,
                                [&](const int frames) { return std::log2(double(frames)); });
  int color = kTrueArmColor + 1;
  for (const PredictorErrors& curve : report.predictors) {
    const int its_color = curve.key == "no_load"   ? kNoLoadColor
                          : curve.key == "network" ? kNetworkColor
                                                   : color++;
    const bool is_yardstick = curve.errors.has_value();
    chart.line(curve.label, x, curve.tip_cm,
               {.color = palette_color(its_color), .dashed = is_yardstick});
  }
  chart.note("Restarted from the recorded backbone every so many frames, and left alone between.");
  return chart.svg();
}

std::vector<fs::path> prediction_paths(const fs::path& folder) {
  std::vector<fs::path> paths;
  for (const auto& [name, restart] : kHorizons) {
    paths.push_back(folder / (std::string(name) + ".csv"));
  }
  return paths;
}

std::vector<fs::path> write_predictions(const fs::path& folder, const ForwardModel& no_load,
                                        const ForwardModel* network,
                                        const std::vector<Episode>& episodes, int jobs) {
  const std::vector<fs::path> paths = prediction_paths(folder);
  const std::vector<FrameMatrix> unloaded = predict(no_load, episodes, Restart::every_frame, jobs);
  for (std::size_t i = 0; i < kHorizons.size(); ++i) {
    write_file_atomically(
        paths[i],
        predictions_csv(episodes, unloaded,
                        network != nullptr ? predict(*network, episodes, kHorizons[i].second, jobs)
                                           : std::vector<FrameMatrix>()));
  }
  return paths;
}

}  // namespace limber
