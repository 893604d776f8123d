#include "limber/report/track_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/units.hpp"
#include "limber/plot/chart.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_report.hpp"

namespace limber {

namespace {

nlohmann::ordered_json with_names(const PlanTrial& trial, const nlohmann::ordered_json& object) {
  nlohmann::ordered_json named = {
      {"environment", trial.environment}, {"model", trial.model}, {"seed", trial.seed}};
  named.update(object);
  return named;
}

using Json = nlohmann::ordered_json;

double percent_of_length(const TrackRun& run, const TrackError& error) {
  return 100.0 * error.rms_m / run.path.length_m();
}

Json to_json(const TrackRun& run, const std::optional<TrackError>& error) {
  if (!error) {
    return nullptr;
  }
  return {{"rmse_cm", kCmPerM * error->rms_m},
          {"rmse_percent_of_length", percent_of_length(run, *error)},
          {"max_cm", kCmPerM * error->max_m},
          {"frames", error->frames}};
}

std::string laps_to_text(const char* laps, const TrackRun& run,
                         const std::optional<TrackError>& error) {
  if (!error) {
    return "";
  }
  return fmt::format(
      "\n  {}: off by {:.2f} cm (RMS), {:.2f} % of the path's length; "
      "at most {:.2f} cm",
      laps, kCmPerM * error->rms_m, percent_of_length(run, *error), kCmPerM * error->max_m);
}

/// Where the tip was in a frame, in cm.
Eigen::Vector2d tip_cm(const Episode& episode, int frame) {
  return kCmPerM * tip_position_m(backbone_at(episode.backbone, frame));
}

}  // namespace

nlohmann::ordered_json planning_to_json(const PlanTrial& trial, const Environment& environment) {
  const Command pressures;  // trials are those of the virtual arm
  return with_names(trial, to_json(trial.planning, pressures, environment.goal, trial.planner,
                                   trial.model, trial.seed));
}

nlohmann::ordered_json execution_to_json(const PlanTrial& trial, const Environment& environment) {
  return with_names(trial, to_json(*trial.execution, environment));
}

Json to_json(const TrackRun& run) {
  return {{"status", to_string(run.result.status)},
          {"message", run.result.message},
          {"path",
           {{"length_cm", kCmPerM * run.path.length_m()},
            {"lap_s", run.path.lap_s()},
            {"laps", run.path.laps}}},
          {"first_lap", to_json(run, run.errors.first_lap)},
          {"later_laps", to_json(run, run.errors.later_laps)},
          {"collided", run.result.collided || run.result.final_backbone ? Json(run.result.collided)
                                                                        : Json(nullptr)},
          {"frames", run.result.frames},
          {"frames_not_seen", run.result.frames_not_seen},
          {"path_starts_at_frame", run.start_frame},
          {"queries", run.queries}};
}

std::string to_text(const TrackRun& run) {
  std::string text = fmt::format("{}, {} frames", to_string(run.result.status), run.result.frames);
  text += laps_to_text("first lap", run, run.errors.first_lap);
  return text + laps_to_text("later laps", run, run.errors.later_laps);
}

std::string track_picture(const TrackRun& run) {
  std::vector<double> path_x, path_y, x, y, time_s, off_cm;
  for (const Eigen::Vector2d& point : run.path.point_m) {
    path_x.push_back(kCmPerM * point.x());
    path_y.push_back(kCmPerM * point.y());
  }
  const Episode& episode = run.result.episode;
  for (int t = run.start_frame; t < episode.frame_count(); ++t) {
    const double since_s = episode.time_s[t] - episode.time_s[run.start_frame];
    const Eigen::Vector2d tip = tip_cm(episode, t);
    x.push_back(tip.x());
    y.push_back(tip.y());
    time_s.push_back(since_s);
    off_cm.push_back((tip - kCmPerM * run.path.at(since_s)).norm());
  }
  Chart paths("The tip's path");
  paths.x_axis("x [cm]").y_axis("y [cm]").equal_aspect().size_px(560, 480);
  paths.line("path", path_x, path_y, {.width_px = 4.0, .opacity = 0.4}).line("tip", x, y);
  Chart off("Distance between tip and path at equal times");
  off.x_axis("time [s]").y_axis("distance [cm]").size_px(900, 300);
  off.line("distance", time_s, off_cm);
  off.horizontal_line("1 % of the length", run.path.length_m() * kCmPerM / 100.0,
                      {.width_px = 1.0, .dashed = true});
  return ChartGrid(1).add(std::move(paths)).add(std::move(off)).svg();
}

}  // namespace limber
