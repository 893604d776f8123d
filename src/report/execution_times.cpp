#include "limber/report/execution_times.hpp"

#include <functional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/units.hpp"
#include "limber/plot/chart.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

constexpr int kTimesWidthPx = 900;
constexpr int kTimesHeightPx = 300;

/// A number of each of `count` frames.
std::vector<double> each_frame(int count, const std::function<double(int)>& number) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) {
    values.push_back(number(k));
  }
  return values;
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
        run_s(each_frame(run.frame_count(), [&](int t) { return run.time_s[t]; })) {}

  const PlanFrame& planned_frame(int k) const { return plan.frames[static_cast<std::size_t>(k)]; }
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
    chart.line(
        fmt::format("{}: the arm", name), run.run_s,
        each_frame(run.episode.frame_count(),
                   [&](int t) { return kCmPerM * double(run.episode.backbone(t, tip + axis)); }),
        {.color = color});
  }
  return chart;
}

/// Clearance of one shape; of an obstacle that appears, from then on.
class ClearanceOverTime {
 public:
  ClearanceOverTime(const ArmDescription& arm, const Environment& environment,
                    const ExecutionResult& result)
      : before_(arm, environment.obstacles),
        after_(arm, with_appeared(environment, result).obstacles),
        appears_s_(result.appeared ? result.appeared->time_s : 0.0) {}

  double clearance_cm(double time_s, const Backbone& shape) const {
    const CollisionChecker& checker = time_s < appears_s_ ? before_ : after_;
    return kCmPerM * checker.clearance(shape).value_m;
  }

 private:
  CollisionChecker before_;
  CollisionChecker after_;
  double appears_s_;
};

Chart clearance_chart(const RunTimes& run, const ClearanceOverTime& clearance) {
  Chart chart = times_chart("Clearance from the nearest obstacle", "clearance [cm]");
  chart.line("predicted", run.planned_s,
             each_frame(run.plan.frame_count(),
                        [&](int k) {
                          return clearance.clearance_cm(run.planned_s[std::size_t(k)],
                                                        run.planned_frame(k).backbone);
                        }),
             {.width_px = 1.5, .dashed = true});
  chart.line("the arm", run.run_s, each_frame(run.episode.frame_count(), [&](int t) {
               return clearance.clearance_cm(run.run_s[std::size_t(t)],
                                             backbone_at(run.episode.backbone, t));
             }));
  chart.horizontal_line("contact", 0.0, {.color = "#b2182b", .width_px = 1.0});
  return chart;
}

}  // namespace

std::string execution_times_picture(const ArmDescription& arm, const Environment& environment,
                                    const Plan& plan, const ExecutionResult& result) {
  const RunTimes run(arm, plan, result.episode);
  ChartGrid grid(1, environment.name + ", over time");
  grid.add(pressures_chart(run));
  if (run.episode.frame_count() > 0) {
    grid.add(tip_chart(run));
    grid.add(clearance_chart(run, ClearanceOverTime(arm, environment, result)));
  }
  return grid.svg();
}

}  // namespace limber
