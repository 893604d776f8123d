#include "limber/logs/import_report.hpp"
#include "limber/arm/names.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limber {

namespace {

constexpr double kNoteworthy = 0.9999;  // points tracked less often are listed

nlohmann::ordered_json to_json(const RunReport& run) {
  nlohmann::ordered_json json;
  json["log"] = run.name;
  json["rows"] = run.rows;
  json["rate_hz"] = run.rate_hz;
  json["duration_s"] = run.duration_s;
  json["points"] = nlohmann::ordered_json::array();
  for (const PointReport& point : run.points) {
    json["points"].push_back(
        {{"name", point.name}, {"plate", point.plate}, {"seen", point.tracked_share}});
  }
  json["base"] = {{"x_m", run.base.x_m},
                  {"y_m", run.base.y_m},
                  {"theta_rad", run.base.theta_rad},
                  {"scatter_m", run.base_scatter_m}};
  json["length_ratio"] = run.length_ratio;
  json["clock"] = nullptr;
  if (run.clock) {
    json["clock"] = {{"time_offset_s", run.clock->offset_s},
                     {"how", run.clock->found ? "correlation" : "given"}};
    if (run.clock->found) {
      json["clock"]["correlation"] = run.clock->correlation;
      json["clock"]["runner_up"] = run.clock->runner_up;
      json["clock"]["lag_s"] = run.clock->lag_s;
    }
  }
  json["notes"] = nlohmann::ordered_json::array();
  for (const ImportNote& note : run.notes) {
    json["notes"].push_back({{"what", note.what}, {"count", note.count}, {"first", note.first}});
  }
  json["episodes"] = run.episodes;
  json["frames"] = run.frames;
  json["frames_not_tracked"] = run.frames_not_tracked;
  return json;
}

std::string clock_text(const ClockReport& clock) {
  if (!clock.found) {
    return fmt::format("\n  clocks: {:+.4f} s added to the pressures' times, as given",
                       clock.offset_s);
  }
  return fmt::format(
      "\n  clocks: {:+.4f} s added to the pressures' times, found by correlation ({:.2f}; the next "
      "best is {:.2f}); repeat with --time-offset-s {:.4f}",
      clock.offset_s, clock.correlation, clock.runner_up, clock.offset_s);
}

std::string to_text(const RunReport& run) {
  std::string text = fmt::format("{}: {} rows at {:.4g} Hz, {:.1f} s", run.name, run.rows,
                                 run.rate_hz, run.duration_s);
  std::string rarely;
  for (const PointReport& point : run.points) {
    if (point.tracked_share < kNoteworthy) {
      rarely += fmt::format("{}{} ({}) {:.1f} %", rarely.empty() ? "" : ", ", point.name,
                            plate_name(point.plate), 100.0 * point.tracked_share);
    }
  }
  text += fmt::format("\n  {} points{}", run.points.size(),
                      rarely.empty() ? ", all seen throughout" : "; seen in: " + rarely);
  text += fmt::format(
      "\n  base: the log's ({:.4f}, {:.4f}) m, {:.4f} rad; it scatters by {:.1f} mm; the arm "
      "measures {:.1f} % of its file's length",
      run.base.x_m, run.base.y_m, run.base.theta_rad, 1e3 * run.base_scatter_m,
      100.0 * run.length_ratio);
  if (run.clock) {
    text += clock_text(*run.clock);
  }
  for (const ImportNote& note : run.notes) {
    text += fmt::format("\n  {}: {}{}", note.what, note.count,
                        note.first.empty() ? "" : fmt::format(", first: {}", note.first));
  }
  return text + fmt::format("\n  gives {} episodes, {} frames, {} of them not tracked",
                            run.episodes, run.frames, run.frames_not_tracked);
}

}  // namespace

void RunReport::note(const std::string& what, const std::string& first, std::int64_t count) {
  const auto known = std::find_if(notes.begin(), notes.end(),
                                  [&](const ImportNote& note) { return note.what == what; });
  if (known != notes.end()) {
    known->count += count;
    return;
  }
  notes.push_back({what, count, first});
}

std::int64_t ImportReport::episodes() const {
  std::int64_t sum = 0;
  for (const RunReport& run : runs) {
    sum += run.episodes;
  }
  return sum;
}

std::int64_t ImportReport::frames() const {
  std::int64_t sum = 0;
  for (const RunReport& run : runs) {
    sum += run.frames;
  }
  return sum;
}

std::int64_t ImportReport::frames_not_tracked() const {
  std::int64_t sum = 0;
  for (const RunReport& run : runs) {
    sum += run.frames_not_tracked;
  }
  return sum;
}

nlohmann::ordered_json to_json(const ImportReport& report) {
  nlohmann::ordered_json json;
  json["episodes"] = report.episodes();
  json["frames"] = report.frames();
  json["frames_not_tracked"] = report.frames_not_tracked();
  json["logs"] = nlohmann::ordered_json::array();
  for (const RunReport& run : report.runs) {
    json["logs"].push_back(to_json(run));
  }
  return json;
}

std::string to_text(const ImportReport& report) {
  std::string text;
  for (const RunReport& run : report.runs) {
    text += to_text(run) + "\n";
  }
  return text + fmt::format("{} episodes, {} frames, {} of them not tracked", report.episodes(),
                            report.frames(), report.frames_not_tracked());
}

}  // namespace limber
