#include "limber/report/driver_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "frame_column.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/plot/chart.hpp"
#include "limber/report/report_page.hpp"

namespace limber {

namespace {

Json to_json(const DeadmanResult& deadman) {
  if (!deadman.tested) {
    return nullptr;
  }
  return {{"vented", deadman.starts_vented ? Json() : Json(deadman.vented)},
          {"starts_vented", deadman.starts_vented},
          {"before_kpa", deadman.before_kpa},
          {"after_kpa", deadman.after_kpa}};
}

std::string in_words(const DeadmanResult& deadman) {
  return !deadman.tested ? std::string("not tested")
         : deadman.starts_vented
             ? std::string(
                   "can't tell: it reads no pressure when it starts, also where it was "
                   "killed under pressure. Close its input by hand: kill -9 limber")
         : deadman.vented
             ? fmt::format("vents ({:.1f} to {:.1f} kPa)", deadman.before_kpa, deadman.after_kpa)
             : fmt::format("DOES NOT VENT ({:.1f} to {:.1f} kPa)", deadman.before_kpa,
                           deadman.after_kpa);
}

std::string pressures_svg(const DriverCheck& check) {
  ChartGrid grid(1, "Set points and what was measured");
  const Eigen::VectorXd& time_s = check.episode.time_s;
  for (int s = 0; s < std::ssize(check.channels); ++s) {
    Chart chart(check.channels[s]);
    chart.x_axis("time [s]").y_axis("pressure [kPa]").size_px(900, 240);
    const std::vector<double> time(time_s.begin(), time_s.end());
    chart.line("set point in force", time, frame_column(check.episode.setpoint_kpa, s),
               {.width_px = 1.0, .dashed = true});
    chart.line("measured", time, frame_column(check.episode.pressure_kpa, s));
    grid.add(chart);
  }
  return grid.svg();
}

std::string round_trip_svg(const DriverCheck& check) {
  Chart chart("From a set point to its state");
  const auto ms = mapped<double>(check.timing.round_trip_s,
                                 [&](const double seconds) { return kMsPerS * seconds; });
  chart.x_axis("round trip [ms]").y_axis("requests").without_legend();
  chart.histogram("round trip", ms);
  return chart.svg();
}

}  // namespace

Json times_in_ms(const std::vector<double>& seconds) {
  if (seconds.empty()) {
    return nullptr;
  }
  return {{"count", seconds.size()},
          {"p50", kMsPerS * median(seconds)},
          {"p99", kMsPerS * quantile(seconds, 0.99)},
          {"p999", kMsPerS * quantile(seconds, 0.999)},
          {"max", kMsPerS * quantile(seconds, 1.0)}};
}

Json to_json(const DriverCheck& check, const IdentifiedValves& valves) {
  Json json = {{"status", check.complaints.empty() ? "ok" : "failed"},
               {"complaints", check.complaints},
               {"driver", check.hello.driver},
               {"device", check.hello.device},
               {"tracked", check.hello.tracked},
               {"real_time", check.hello.real_time},
               {"frames", check.timing.late_s.size()},
               {"frames_without_backbone", check.timing.frames_unseen},
               {"skipped_slots", check.timing.skipped_slots},
               {"late_ms", times_in_ms(check.timing.late_s)},
               {"round_trip_ms", times_in_ms(check.timing.round_trip_s)},
               {"zero_kpa", check.zero_kpa},
               {"noise_kpa", check.noise_kpa}};
  json["steps"] = Json::array();
  for (const StepResponse& step : check.steps) {
    json["steps"].push_back({{check.hello.chambers > 0 ? "chamber" : "segment", step.channel},
                             {"setpoint_kpa", step.setpoint_kpa},
                             {"reached_kpa", step.reached_kpa},
                             {"answered", step.answered},
                             {"dead_time_s", step.dead_time_s},
                             {"rise_time_s", step.rise_time_s},
                             {"overshoot_kpa", step.overshoot_kpa}});
  }
  json["deadmen"] = {{"silence", to_json(check.silence)},
                     {"end_of_input", to_json(check.end_of_input)}};
  json["valves"] = to_json(valves);
  return json;
}

std::string to_text(const DriverCheck& check) {
  const auto or_unnamed = [](const std::string& text) { return text.empty() ? "unnamed" : text; };
  std::string text = fmt::format(
      "driver {} (device: {})\n  round trip {:.1f} ms (median), {:.1f} ms (99.9 %); set points "
      "leave at most {:.1f} ms after their slot, {} slots were skipped",
      or_unnamed(check.hello.driver), or_unnamed(check.hello.device),
      kMsPerS * median(check.timing.round_trip_s),
      kMsPerS * quantile(check.timing.round_trip_s, 0.999),
      kMsPerS * quantile(check.timing.late_s, 1.0), check.timing.skipped_slots);
  text += fmt::format("\n  at rest: {:.2f} kPa, noise {:.2f} kPa", fmt::join(check.zero_kpa, ", "),
                      fmt::join(check.noise_kpa, ", "));
  for (const StepResponse& step : check.steps) {
    const std::string& name = check.channels[step.channel];
    text += fmt::format("\n  {} to {:.0f} kPa: ", name, step.setpoint_kpa);
    text +=
        step.answered
            ? fmt::format("{:.1f} kPa, dead time {:.2f} s, rise {:.2f} s, overshoot {:.1f} kPa",
                          step.reached_kpa, step.dead_time_s, step.rise_time_s, step.overshoot_kpa)
            : fmt::format("no answer ({:.1f} kPa)", step.reached_kpa);
  }
  text += fmt::format("\n  without a set: {}\n  at the end of its input: {}",
                      in_words(check.silence), in_words(check.end_of_input));
  for (const std::string& complaint : check.complaints) {
    text += "\n  wrong: " + complaint;
  }
  return text;
}

std::string driver_check_to_html(const DriverCheck& check, const ArmDescription& arm,
                                 const IdentifiedValves& valves) {
  ReportPage page("Driver check");
  page.code(to_text(check))
      .figure({pressures_svg(check), "Each segment alone, to either side: pulses, then jumps"})
      .figure({round_trip_svg(check), "How long states took"})
      .heading("Valves")
      .paragraph(to_text(valves, arm.command.unit, arm.dimension));
  return page.html();
}

}  // namespace limber
