#include "limber/logs/import_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/units.hpp"
#include "shared_base.hpp"

namespace limber {

namespace {

Json three(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string three_text(const Eigen::Vector3d& v) {
  // −0 would look like a finding.
  return fmt::format("({:.4f}, {:.4f}, {:.4f})", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

std::string base_text(const SpaceRunReport& report) {
  const std::string tracked =
      report.base_tracked ? fmt::format("it scatters by {:.1f} mm", kMmPerM * report.base_scatter_m)
                          : std::string("not tracked: it is where the mapping says");
  return fmt::format(
      "\n  base: the log's {} m; x along {}, y along {}{}; {}", three_text(report.base_m),
      three_text(report.x_axis), three_text(report.y_axis),
      report.y_chosen ? ", any perpendicular (the mapping has no y_axis)" : "", tracked);
}

std::string gap_text(const SpaceGapReport& gap, bool lifted) {
  std::string text = fmt::format(
      "\n  {} to {}: {:.1f} mm along the arc, 5 to 95 % {:.1f} to {:.1f}; the arm file has {:.1f}",
      plate_name(gap.from), plate_name(gap.to), kMmPerM * gap.length_m, kMmPerM * gap.shortest_m,
      kMmPerM * gap.longest_m, kMmPerM * gap.arm_m);
  if (!lifted) {
    text +=
        fmt::format("; measured rotations are {:.1f} degrees off it", kDegPerRad * gap.off_arc_rad);
  }
  return text;
}

std::string flips_text(const SpaceFlips& flips) {
  std::string text = fmt::format(
      "\n  '{}' ({}) jumps while its place does not, by up to {:.0f} degrees, first at {:.3f} s:",
      flips.point, plate_name(flips.plate), kDegPerRad * flips.largest_rad, flips.first_s);
  const char* separator = " ";
  const auto add = [&](std::int64_t count, const std::string& what) {
    if (count > 0) {
      text += fmt::format("{}{} {}", separator, count, what);
      separator = "; ";
    }
  };
  add(flips.hidden_rows, "single rows hidden");
  add(flips.turned_rows,
      fmt::format("rows of {} lasting flips turned back to what most rows show", flips.kinds));
  add(flips.jumps, "lasting jumps of less than 30 degrees left as they are");
  return text;
}

Json to_json(const SpaceRunReport& report) {
  Json json;
  json["base"] = {{"position_m", three(report.base_m)}, {"x_axis", three(report.x_axis)},
                  {"y_axis", three(report.y_axis)},     {"y_chosen", report.y_chosen},
                  {"tracked", report.base_tracked},     {"scatter_m", report.base_scatter_m}};
  json["rotations"] = report.lifted ? "lifted" : "measured";
  json["gaps"] = Json::array();
  for (const SpaceGapReport& gap : report.gaps) {
    json["gaps"].push_back({{"from_plate", gap.from},
                            {"to_plate", gap.to},
                            {"arm_m", gap.arm_m},
                            {"length_m", gap.length_m},
                            {"shortest_m", gap.shortest_m},
                            {"longest_m", gap.longest_m},
                            {"off_arc_rad", report.lifted ? Json() : Json(gap.off_arc_rad)}});
  }
  json["plates"] = Json::array();
  for (const SpacePlateReport& plate : report.plates) {
    json["plates"].push_back({{"plate", plate.plate}, {"strays_m", plate.strays_m}});
  }
  json["flips"] = Json::array();
  for (const SpaceFlips& flips : report.flips) {
    json["flips"].push_back({{"point", flips.point},
                             {"plate", flips.plate},
                             {"hidden_rows", flips.hidden_rows},
                             {"turned_rows", flips.turned_rows},
                             {"kinds", flips.kinds},
                             {"jumps", flips.jumps},
                             {"first_s", flips.first_s},
                             {"largest_rad", flips.largest_rad}});
  }
  json["repeated_rows"] = report.repeated_rows;
  return json;
}

/// Lines of a log's report, each after a line break.
std::string to_text(const SpaceRunReport& report) {
  std::string text = base_text(report);
  if (report.lifted) {
    text += "\n  positions only: poses are lifted from them, each gap an arc without twist";
  }
  for (const SpaceGapReport& gap : report.gaps) {
    text += gap_text(gap, report.lifted);
  }
  const char* separator = "\n  95 % of the rows lie within";
  for (const SpacePlateReport& plate : report.plates) {
    if (plate.plate > 0) {
      text += fmt::format("{} {:.1f} mm of the median place of {}", separator,
                          kMmPerM * plate.strays_m, plate_name(plate.plate));
      separator = ",";
    }
  }
  for (const SpaceFlips& flips : report.flips) {
    text += flips_text(flips);
  }
  if (report.repeated_rows > 0) {
    text += fmt::format(
        "\n  rows left out that show the pose before again, within half the median period: {}",
        report.repeated_rows);
  }
  return text;
}

constexpr std::size_t kFewLogs = 3;     // more of them get a line each
constexpr double kNoteworthy = 0.9999;  // points tracked less often are listed

Json to_json(const RunReport& run) {
  Json json;
  json["log"] = run.name;
  json["rows"] = run.rows;
  json["rate_hz"] = run.rate_hz;
  json["duration_s"] = run.duration_s;
  json["points"] = Json::array();
  for (const PointReport& point : run.points) {
    json["points"].push_back(
        {{"name", point.name}, {"plate", point.plate}, {"tracked", point.tracked_share}});
  }
  if (run.space) {
    json.update(to_json(*run.space));
  } else {
    json["base"] = {{"x_m", run.base.x_m},
                    {"y_m", run.base.y_m},
                    {"theta_rad", run.base.theta_rad},
                    {"scatter_m", run.base_scatter_m}};
    json["length_ratio"] = run.length_ratio;
  }
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
  json["notes"] = Json::array();
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
    return fmt::format("\n  clocks: {:+.4f} s added to the commands' times, as given",
                       clock.offset_s);
  }
  return fmt::format(
      "\n  clocks: {:+.4f} s added to the commands' times, found by correlation ({:.2f}; the next "
      "best is {:.2f}); repeat with --time-offset-s {:.4f}",
      clock.offset_s, clock.correlation, clock.runner_up, clock.offset_s);
}

std::string base_text(const RunReport& run) {
  return fmt::format(
      "\n  base: the log's ({:.4f}, {:.4f}) m, {:.4f} rad; it scatters by {:.1f} mm; the arm "
      "measures {:.1f} % of its file's length",
      run.base.x_m, run.base.y_m, run.base.theta_rad, kMmPerM * run.base_scatter_m,
      100.0 * run.length_ratio);
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
                      rarely.empty() ? ", all tracked throughout" : "; tracked in: " + rarely);
  text += run.space ? to_text(*run.space) : base_text(run);
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

Json to_json(const std::vector<SegmentCheck>& columns) {
  return mapped<Json>(columns, [&](const SegmentCheck& segment) {
    return Json{{"correlation", segment.correlation},
                {"follows_weakly", segment.follows_weakly},
                {"undecidable", segment.undecidable.empty() ? Json() : Json(segment.undecidable)}};
  });
}

std::string to_text(const std::vector<SegmentCheck>& columns) {
  std::string text = "columns: levels of commands and segments correlate by";
  std::string notes;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const SegmentCheck& segment = columns[i];
    const std::string name = segment_name(Eigen::Index(i));
    text += fmt::format("{} {:.2f}", i == 0 ? "" : ",", segment.correlation);
    if (segment.follows_weakly) {
      notes += fmt::format(
          "\n  {} hardly follows its command (correlation {:.2f}): is it the right column?", name,
          segment.correlation);
    }
    if (!segment.undecidable.empty()) {
      notes += fmt::format(
          "\n  {}: whether its column is its own can't be told from these logs: {}. Record a log "
          "in which every segment moves on its own",
          name, segment.undecidable);
    }
  }
  return text + notes + "\n";
}

/// What of an arm in space tells a wrong file or tracker, in a few words.
std::string few_words(const SpaceRunReport& report) {
  const auto flips = sum_of<std::int64_t>(report.flips, [&](const SpaceFlips& body) {
    return body.hidden_rows + body.turned_rows + body.jumps;
  });
  double farthest = 0.0;  // from the arm file's length, a share of it
  double off_arc_rad = 0.0;
  for (const SpaceGapReport& gap : report.gaps) {
    const double share = gap.length_m / gap.arm_m - 1.0;
    farthest = std::abs(share) > std::abs(farthest) ? share : farthest;
    off_arc_rad = std::max(off_arc_rad, gap.off_arc_rad);
  }
  std::string text = fmt::format(", worst gap {:+.0f} %", 100.0 * farthest);
  if (!report.lifted) {
    text += fmt::format(", {:.0f} degrees off its arc", kDegPerRad * off_arc_rad);
  }
  return flips > 0 ? text + fmt::format(", {} rows of flips", flips) : text;
}

std::string one_line(const RunReport& run) {
  std::string text = fmt::format("{}: {:.4g} Hz, {:.1f} s, {} episodes, {} frames", run.name,
                                 run.rate_hz, run.duration_s, run.episodes, run.frames);
  if (run.frames_not_tracked > 0) {
    text += fmt::format(", {} not tracked", run.frames_not_tracked);
  }
  if (run.clock) {
    text += fmt::format(", clock {:+.4f} s", run.clock->offset_s);
  }
  if (run.base.x_m != 0.0 || run.base.y_m != 0.0 || run.base.theta_rad != 0.0) {
    text += fmt::format(", base at ({:.4f}, {:.4f}) m, {:.4f} rad of the log", run.base.x_m,
                        run.base.y_m, run.base.theta_rad);
  }
  return text + (run.space ? few_words(*run.space) : std::string());
}

/// What was noted of many logs, each kind once: in how many, how often, and where first.
std::string notes_of_all(const std::vector<RunReport>& runs) {
  struct Joined {
    std::int64_t logs = 0;
    std::int64_t count = 0;
    std::string first;
  };
  std::vector<std::string> order;
  std::map<std::string, Joined> kinds;
  for (const RunReport& run : runs) {
    for (const ImportNote& note : run.notes) {
      const auto [entry, is_new] = kinds.try_emplace(note.what);
      if (is_new) {
        order.push_back(note.what);
        entry->second.first = run.name + (note.first.empty() ? std::string() : ", " + note.first);
      }
      ++entry->second.logs;
      entry->second.count += note.count;
    }
  }
  std::string text;
  for (const std::string& what : order) {
    const Joined& joined = kinds.at(what);
    text += fmt::format("{}: {} times in {} of {} logs, first: {}\n", what, joined.count,
                        joined.logs, runs.size(), joined.first);
  }
  return text;
}

/// What the simple model says of each episode; outliers by the logs that they came from.
std::string episodes_to_text(const EpisodeErrors& errors) {
  std::string text = fmt::format(
      "simple model: its error at the tip is {:.2f} cm in the median episode\n", errors.median_cm);
  for (const int number : errors.outliers()) {
    const EpisodeError& episode = errors.episodes[number];
    text +=
        fmt::format("  {} is broken: {}. limber train leaves it out\n", episode.name, episode.why);
  }
  return text;
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

std::int64_t ImportReport::sum(std::int64_t RunReport::*number) const {
  return sum_of<std::int64_t>(runs, [&](const RunReport& run) { return run.*number; });
}

Json to_json(const ImportReport& report) {
  Json json;
  json["episodes"] = report.sum(&RunReport::episodes);
  json["frames"] = report.sum(&RunReport::frames);
  json["frames_not_tracked"] = report.sum(&RunReport::frames_not_tracked);
  json["logs"] = Json::array();
  for (const RunReport& run : report.runs) {
    json["logs"].push_back(to_json(run));
  }
  json["base"] = report.base ? to_json(*report.base) : Json();
  json["columns"] = to_json(report.columns);
  json["episode_errors"] = report.episode_errors ? to_json(*report.episode_errors) : Json();
  return json;
}

std::string to_text(const ImportReport& report) {
  std::string text;
  const bool many = report.runs.size() > kFewLogs;
  for (const RunReport& run : report.runs) {
    text += (many ? one_line(run) : to_text(run)) + "\n";
  }
  text += many ? notes_of_all(report.runs) : std::string();
  text += report.base ? to_text(*report.base, std::ssize(report.runs)) : std::string();
  text += report.columns.empty() ? "" : to_text(report.columns);
  if (report.episode_errors) {
    text += episodes_to_text(*report.episode_errors);
  }
  return text + fmt::format("{} episodes, {} frames, {} of them not tracked",
                            report.sum(&RunReport::episodes), report.sum(&RunReport::frames),
                            report.sum(&RunReport::frames_not_tracked));
}

}  // namespace limber
