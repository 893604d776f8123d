#include "limber/report/valve_plot.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "frame_column.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/data/valve_simulation.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

namespace {

constexpr int kCurvePoints = 100;
constexpr double kPercent = 100.0;

constexpr double kShownS = 12.0;

/// Sum of all set points' changes within a range.
double change_within(const Episode& episode, int first, int count) {
  const auto set = episode.setpoint_kpa.middleRows(first, count).cast<double>();
  return (set.bottomRows(count - 1) - set.topRows(count - 1)).cwiseAbs().sum();
}

/// The stretch of about `kShownS` that shows most, from the start of a held-back range or whole
/// stretches after it.
FrameRange liveliest(const Recording& recording) {
  FrameRange best;
  double max_change = -1.0;
  const int frames = std::max(2, int(std::lround(kShownS * recording.rate_hz)));
  for (const FrameRange& range : split_for_valves(recording.episodes).held_back) {
    for (int at = 0; at + 1 < range.count; at += frames) {
      const FrameRange stretch{range.episode, range.first + at, std::min(frames, range.count - at)};
      const double change = change_within(recording.episodes[std::size_t(range.episode)],
                                          stretch.first, stretch.count);
      if (stretch.count > 1 && change > max_change) {
        max_change = change;
        best = stretch;
      }
    }
  }
  refuse_if(max_change < 0.0, "the recording is too short for a picture of its valves");
  return best;
}

}  // namespace

Chart bench_chart(const CharacterisedArm& result, const BenchData& bench) {
  Chart chart(fmt::format("Characterisation of {}", result.arm.name));
  chart.x_axis("gauge pressure of the inflated side [kPa]");
  chart.y_axis("contraction of that side [% of its length]");
  for (std::size_t i = 0; i < result.fits.size(); ++i) {
    const StrainFit& fit = result.fits[i];
    const SeriesStyle style{.color = palette_color(int(i))};
    std::vector<double> x, y;
    for (int k = 0; k <= kCurvePoints; ++k) {
      x.push_back(fit.pressure_limit_kpa * k / kCurvePoints);
      y.push_back(kPercent * strain_at(fit.polynomial, x.back()));
    }
    chart.line(fmt::format("{}, quartic{}", segment_name(i), fit.refitted ? " (slope held)" : ""),
               x, y, style);
    std::vector<double> pressures, contractions;
    for (const BenchPoint& point : bench[i]) {
      pressures.push_back(point.pressure_kpa);
      contractions.push_back(-kPercent * point.strain);
    }
    chart.points(fmt::format("{}, bench", segment_name(i)), pressures, contractions, style);
  }
  return chart;
}

std::string valve_plot_svg(const ValveParameters& valves, const Recording& recording) {
  Recording told = recording;
  if (!setpoints_are_measured(told.episodes)) {
    leave_out_measured_setpoints(told.episodes);  // as the fit does
  }
  const FrameRange range = liveliest(told);
  const Episode& episode = told.episodes[std::size_t(range.episode)];
  const FrameMatrix modelled =
      simulate_valves(valves, recording.rate_hz, episode, range.first, range.count);
  const Eigen::VectorXd time_s = episode.time_s.segment(range.first, range.count);
  const std::vector<double> time(time_s.begin(), time_s.end());
  ChartGrid grid(1, "Valves: a motion that they were not fitted to");
  for (int i = 0; i < recording.channel_count(); ++i) {
    Chart chart(channel_name(recording.dimension, i));
    chart.x_axis("time [s]")
        .y_axis(fmt::format("{} [{}]", recording.command.name, recording.command.unit))
        .size_px(900, 260);
    chart.line("set point", time,
               frame_column(episode.setpoint_kpa.middleRows(range.first, range.count), i),
               {.width_px = 1.0, .dashed = true});
    chart.line("measured", time,
               frame_column(episode.pressure_kpa.middleRows(range.first, range.count), i),
               {.width_px = 4.0, .opacity = 0.5});
    if (!valves.is_ideal()) {
      chart.line("modelled from the set points", time, frame_column(modelled, i));
    }
    grid.add(chart);
  }
  return grid.svg();
}

}  // namespace limber
