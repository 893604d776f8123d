#include "limber/report/track_report.hpp"

#include <functional>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/units.hpp"
#include "limber/plot/chart.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_report.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

constexpr int kTimesWidthPx = 900;
constexpr int kTimesHeightPx = 300;

/// A number of each of `count` frames; NaN leaves a gap.
std::vector<double> each_frame(int count, const std::function<double(int)>& number) {
  return mapped<double>(count, [&](int k) { return number(k); });
}

/// What the charts share.
struct RunTimes {
  const ArmDescription& arm;
  const Plan& plan;
  const Episode& episode;
  std::vector<double> planned_s;
  std::vector<double> run_s;

  RunTimes(const ArmDescription& of, const Plan& planned, const Episode& run)
      : arm(of),
        plan(planned),
        episode(run),
        planned_s(
            each_frame(planned.frame_count(), [&](int k) { return k * of.frame_period_s(); })),
        run_s(run.time_s.begin(), run.time_s.end()) {}

  const PlanFrame& planned_frame(int k) const { return plan.frames[k]; }
  /// A number of each frame of the run; none of those in which nobody saw the arm.
  std::vector<double> each_seen(const std::function<double(int)>& number) const {
    return each_frame(episode.frame_count(), [&](int t) {
      return episode.was_tracked(t) ? number(t) : std::numeric_limits<double>::quiet_NaN();
    });
  }
};

Chart times_chart(const std::string& title, const std::string& y_label) {
  Chart chart(title);
  chart.x_axis("time [s]").y_axis(y_label).size_px(kTimesWidthPx, kTimesHeightPx);
  return chart;
}

Chart pressures_chart(const RunTimes& run) {
  Chart chart = times_chart("Set points and pressures",
                            fmt::format("{} [{}]", run.arm.command.name, run.arm.command.unit));
  const int frames = run.episode.frame_count();
  for (int i = 0; i < run.arm.segment_count(); ++i) {
    const std::string color = palette_color(i + 3);
    chart.line(segment_name(i) + ": set point", run.run_s,
               each_frame(frames, [&](int t) { return double(run.episode.setpoint_kpa(t, i)); }),
               {.color = color, .width_px = 1.0, .dashed = true});
    chart.line(segment_name(i) + ": predicted", run.planned_s,
               each_frame(run.plan.frame_count(),
                          [&](int k) { return double(run.planned_frame(k).pressure_kpa[i]); }),
               {.color = color, .width_px = 4.0, .opacity = 0.4});
    if (!run.episode.setpoints_only) {
      chart.line(segment_name(i) + ": measured", run.run_s,
                 each_frame(frames, [&](int t) { return double(run.episode.pressure_kpa(t, i)); }),
                 {.color = color});
    }
  }
  return chart;
}

Chart tip_chart(const RunTimes& run) {
  Chart chart = times_chart("Tip", "position [cm]");
  const Eigen::Index tip = run.episode.backbone.cols() - kPoseSize;
  for (int axis = 0; axis < 2; ++axis) {
    const char* name = axis == 0 ? "x" : "y";
    const std::string color = palette_color(axis);
    chart.line(fmt::format("{}: predicted", name), run.planned_s,
               each_frame(run.plan.frame_count(),
                          [&](int k) {
                            const Backbone& shape = run.planned_frame(k).backbone;
                            return kCmPerM * double(shape(shape.rows() - 1, axis));
                          }),
               {.color = color, .width_px = 1.5, .dashed = true});
    chart.line(fmt::format("{}: the arm", name), run.run_s, run.each_seen([&](int t) {
      return kCmPerM * double(run.episode.backbone(t, tip + axis));
    }),
               {.color = color});
  }
  return chart;
}

/// Of an obstacle that appears, from then on.
Chart clearance_chart(const RunTimes& run, const Environment& environment,
                      const ExecutionResult& result) {
  const CollisionChecker before(run.arm, environment.obstacles);
  const CollisionChecker after(run.arm, with_appeared(environment, result).obstacles);
  const double appears_s = result.appeared ? result.appeared->time_s : 0.0;
  const auto clearance_cm = [&](double time_s, const Backbone& shape) {
    return kCmPerM * (time_s < appears_s ? before : after).clearance(shape).value_m;
  };
  Chart chart = times_chart("Clearance from the nearest obstacle", "clearance [cm]");
  chart.line("predicted", run.planned_s,
             each_frame(run.plan.frame_count(),
                        [&](int k) {
                          return clearance_cm(run.planned_s[std::size_t(k)],
                                              run.planned_frame(k).backbone);
                        }),
             {.width_px = 1.5, .dashed = true});
  chart.line("the arm", run.run_s, run.each_seen([&](int t) {
    return clearance_cm(run.run_s[std::size_t(t)], backbone_at(run.episode.backbone, t));
  }));
  chart.horizontal_line("contact", 0.0, {.color = "#b2182b", .width_px = 1.0});
  return chart;
}

Json with_names(const PlanTrial& trial, const Json& object) {
  Json named = {{"environment", trial.environment}, {"model", trial.model}, {"seed", trial.seed}};
  named.update(object);
  return named;
}

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
      "\n  {}: off by {:.2f} cm (RMS), {:.2f} % of the path's length; at most {:.2f} cm", laps,
      kCmPerM * error->rms_m, percent_of_length(run, *error), kCmPerM * error->max_m);
}

}  // namespace

std::string execution_pressures_picture(const ArmDescription& arm, const Plan& plan,
                                        const ExecutionResult& result) {
  return pressures_chart(RunTimes(arm, plan, result.episode)).svg();
}

std::string execution_times_picture(const ArmDescription& arm, const Environment& environment,
                                    const Plan& plan, const ExecutionResult& result) {
  const RunTimes run(arm, plan, result.episode);
  ChartGrid grid(1, environment.name + ", over time");
  grid.add(pressures_chart(run));
  if (run.episode.frame_count() > 0) {
    grid.add(tip_chart(run));
  }
  if (run.episode.frame_count() > 0 && !with_appeared(environment, result).obstacles.empty()) {
    grid.add(clearance_chart(run, environment, result));
  }
  return grid.svg();
}

Json planning_to_json(const PlanTrial& trial, const Environment& environment) {
  const Command pressures;  // trials are those of the virtual arm
  return with_names(trial, to_json(trial.planning, pressures, environment.goal, trial.planner,
                                   trial.model, trial.seed));
}

Json execution_to_json(const PlanTrial& trial, const Environment& environment) {
  return with_names(trial, to_json(*trial.execution, environment));
}

Json to_json(const TrackRun& run) {
  return {
      {"status", to_string(run.result.status)},
      {"message", run.result.message},
      {"path",
       {{"length_cm", kCmPerM * run.path.length_m()},
        {"lap_s", run.path.lap_s()},
        {"laps", run.path.laps}}},
      {"first_lap", to_json(run, run.errors.first_lap)},
      {"later_laps", to_json(run, run.errors.later_laps)},
      {"collided", run.result.collided || run.result.final_backbone ? Json(run.result.collided)
                                                                    : Json(nullptr)},
      {"min_clearance_cm",
       run.result.closest ? Json(kCmPerM * run.result.closest->clearance.value_m) : Json(nullptr)},
      {"goal_reached", nullptr},  // these four as of a plan, for scripts: there is no goal
      {"distance_to_goal_cm", nullptr},
      {"orientation_to_goal_rad", nullptr},
      {"prediction_error_cm", nullptr},
      {"replans", run.result.replans},
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
    const Eigen::Vector2d tip_cm = kCmPerM * tip_position_m(backbone_at(episode.backbone, t));
    x.push_back(tip_cm.x());
    y.push_back(tip_cm.y());
    time_s.push_back(since_s);
    off_cm.push_back((tip_cm - kCmPerM * run.path.at(since_s)).norm());
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
