#include "space_report.hpp"

#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMm = 1e3;

nlohmann::ordered_json three(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string three_text(const Eigen::Vector3d& v) {
  // −0 would look like a finding.
  return fmt::format("({:.4f}, {:.4f}, {:.4f})", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

std::string base_text(const SpaceRunReport& report) {
  const std::string tracked =
      report.base_tracked ? fmt::format("it scatters by {:.1f} mm", kMm * report.base_scatter_m)
                          : std::string("not tracked: it is where the mapping says");
  return fmt::format(
      "\n  base: the log's {} m; x along {}, y along {}{}; {}", three_text(report.base_m),
      three_text(report.x_axis), three_text(report.y_axis),
      report.y_chosen ? ", any perpendicular (the mapping has no y_axis)" : "", tracked);
}

std::string gap_text(const SpaceGapReport& gap, bool lifted) {
  std::string text = fmt::format(
      "\n  {} to {}: {:.1f} mm along the arc, 5 to 95 % {:.1f} to {:.1f}; the arm file has {:.1f}",
      plate_name(gap.from), plate_name(gap.to), kMm * gap.length_m, kMm * gap.shortest_m,
      kMm * gap.longest_m, kMm * gap.arm_m);
  if (!lifted) {
    text +=
        fmt::format("; measured rotations are {:.1f} degrees off it", kDegrees * gap.off_arc_rad);
  }
  return text;
}

std::string flips_text(const SpaceFlips& flips) {
  std::string text = fmt::format(
      "\n  '{}' ({}) jumps while its place does not, by up to {:.0f} "
      "degrees, first at {:.3f} s:",
      flips.point, plate_name(flips.plate), kDegrees * flips.largest_rad, flips.first_s);
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

}  // namespace

nlohmann::ordered_json to_json(const SpaceRunReport& report) {
  nlohmann::ordered_json json;
  json["base"] = {{"position_m", three(report.base_m)}, {"x_axis", three(report.x_axis)},
                  {"y_axis", three(report.y_axis)},     {"y_chosen", report.y_chosen},
                  {"tracked", report.base_tracked},     {"scatter_m", report.base_scatter_m}};
  json["rotations"] = report.lifted ? "lifted" : "measured";
  json["gaps"] = nlohmann::ordered_json::array();
  for (const SpaceGapReport& gap : report.gaps) {
    json["gaps"].push_back(
        {{"from_plate", gap.from},
         {"to_plate", gap.to},
         {"arm_m", gap.arm_m},
         {"length_m", gap.length_m},
         {"shortest_m", gap.shortest_m},
         {"longest_m", gap.longest_m},
         {"off_arc_rad",
          report.lifted ? nlohmann::ordered_json() : nlohmann::ordered_json(gap.off_arc_rad)}});
  }
  json["plates"] = nlohmann::ordered_json::array();
  for (const SpacePlateReport& plate : report.plates) {
    json["plates"].push_back({{"plate", plate.plate}, {"strays_m", plate.strays_m}});
  }
  json["flips"] = nlohmann::ordered_json::array();
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
      text += fmt::format("{} {:.1f} mm of the median place of {}", separator, kMm * plate.strays_m,
                          plate_name(plate.plate));
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

}  // namespace limber
