#include "limber/logs/import_mapping.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/yaml_reader.hpp"
#include "space_mapping.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/import/1";
constexpr double kLongestGap_s = 10.0;

TimeColumn read_time(const YamlReader& node) {
  node.refuse_unknown_keys({"column", "unit", "rate_hz"});
  TimeColumn time;
  if (!node.has("column") && node.has("rate_hz")) {
    // Rows that follow each other without a stamp are counted, as a column of frames counts them.
    node.refuse_unknown_keys({"rate_hz"});
    time = {"", 1.0, "frame"};
  } else {
    time.column = named_column(node.at("column"));
    if (node.has("rate_hz") && !(node.has("unit") && node.at("unit").text() == "frame")) {
      node.at("rate_hz").refuse("belongs to a column of frames (unit: frame), or to no column");
    }
  }
  node.read_if_there("unit", time.unit, &YamlReader::text);
  if (time.unit == "frame") {
    time.seconds_per_unit = 1.0 / node.at("rate_hz").positive("frames per second");
  } else {
    time.seconds_per_unit = node.has("unit") ? factor_to(node.at("unit"), "s") : 1.0;
  }
  return time;
}

std::vector<std::string> read_names(const YamlReader& node, std::size_t count,
                                    const std::string& each) {
  std::vector<std::string> names;
  for (const YamlReader& element : node.elements()) {
    const std::string name = named_column(element);
    element.refuse_if(std::find(names.begin(), names.end(), name) != names.end(),
                      "'{}' is named twice", name);
    names.push_back(name);
  }
  node.refuse_if(names.size() != count, "{} columns found; expected {}, {}", names.size(), count,
                 each);
  return names;
}

/// Whether what is named beside set points was measured. Pressures are, unless the mapping says
/// otherwise; commands alone are set points.
bool read_measured(const YamlReader& node, const std::string& key, bool setpoints_alone,
                   bool has_setpoints) {
  const bool usual = !setpoints_alone && (key == "pressures" || has_setpoints);
  if (!node.has("measured")) {
    return usual;
  }
  const bool measured = node.at("measured").boolean();
  if (measured && setpoints_alone) {
    node.at("measured").refuse("true found; 'setpoints' alone name nothing that was measured");
  }
  if (!measured && has_setpoints) {
    node.at("measured")
        .refuse(
            "false found, with 'setpoints' beside other columns; expected "
            "one of both: where nothing was measured, 'setpoints' alone");
  }
  return measured;
}

/// Whether the columns are those of the arm file's `commands`: where it has such, unless the
/// mapping says otherwise.
bool read_summed(const YamlReader& node, const ArmDescription& arm) {
  if (!node.has("of")) {
    return !arm.commands.empty();
  }
  const std::string of = node.at("of").text();
  if (of != "segments" && (of != "commands" || arm.commands.empty())) {
    node.at("of").refuse(
        fmt::format("{} found; expected segments{}", node.at("of").found(),
                    arm.commands.empty() ? ": the arm's file has no 'commands'" : " or commands"));
  }
  return of == "commands";
}

std::string one_for_each(bool summed, const ArmDescription& arm) {
  if (summed) {
    return fmt::format("one for each command of arm '{}', in its file's order", arm.name);
  }
  return arm.is_spatial()
             ? fmt::format("one for each chamber of arm '{}', base first", arm.name)
             : fmt::format(
                   "one for each segment of arm '{}', base first. If they are commands of the "
                   "arm's own, limber characterize --commands finds what they act on",
                   arm.name);
}

void refuse_sides(const YamlReader& node, bool summed, const ArmDescription& arm) {
  for (const char* side : {"right", "left"}) {
    if (summed && node.has(side)) {
      node.at(side).refuse(
          "the arm's file has 'commands', which are signed: expected 'columns', one for each");
    }
    if (arm.is_spatial() && node.has(side)) {
      node.at(side).refuse(
          "chambers of an arm in space have no sides: expected 'columns', one for each chamber");
    }
  }
}

/// Such as the pressure of the air around, where gauges are absolute: one number, or one for each.
std::vector<double> read_offsets(const YamlReader& node, std::size_t count,
                                 const std::string& each) {
  const char* const kMeaning = "what is added, in the log's unit";
  if (!node.is_sequence()) {
    return {node.number(kMeaning)};
  }
  std::vector<double> offsets = node.numbers(kMeaning);
  node.refuse_if(offsets.size() != count, "{} numbers found; expected one for all, or {}, {}",
                 offsets.size(), count, each);
  return offsets;
}

CommandColumns read_commands(const YamlReader& node, const std::string& key,
                             const ArmDescription& arm, const TimeColumn& time) {
  node.refuse_unknown_keys(
      {"unit", "offset", "of", "columns", "right", "left", "setpoints", "measured", "time"});
  CommandColumns commands;
  commands.summed = read_summed(node, arm);
  const std::size_t n = commands.summed ? arm.commands.size() : std::size_t(arm.channel_count());
  const std::string each = one_for_each(commands.summed, arm);
  commands.time = node.has("time") ? read_time(node.at("time")) : time;
  commands.unit = node.has("unit") ? node.at("unit").text() : arm.command.unit;
  if (node.has("unit")) {
    commands.factor = factor_to(node.at("unit"), arm.command.unit);
  }
  refuse_sides(node, commands.summed, arm);
  const bool sided = node.has("right") && node.has("left");
  const bool setpoints_alone =
      node.has("setpoints") && !node.has("columns") && !node.has("right") && !node.has("left");
  const bool one_sided = node.has("right") != node.has("left");
  if ((node.has("columns") == sided || one_sided) && !setpoints_alone) {
    node.refuse(fmt::format(
        "expected either 'columns', signed{}, or both 'right' and 'left', one column a side; or "
        "'setpoints' alone, where nothing was measured",
        arm.no_load == NoLoadKind::strain_polynomial ? ", positive to the right" : ""));
  }
  if (node.has("columns") || setpoints_alone) {
    commands.columns = read_names(node.at(setpoints_alone ? "setpoints" : "columns"), n, each);
  } else {
    commands.right = read_names(node.at("right"), n, each);
    commands.left = read_names(node.at("left"), n, each);
  }
  if (node.has("setpoints") && !setpoints_alone) {
    commands.setpoint = read_names(node.at("setpoints"), n, each);
  }
  commands.measured = read_measured(node, key, setpoints_alone, !commands.setpoint.empty());
  if (node.has("offset")) {
    commands.offsets = read_offsets(node.at("offset"), n, each);
  }
  return commands;
}

PointSource read_point(const YamlReader& node) {
  node.refuse_unknown_keys({"plate", "x", "y", "theta", "body", "marker", "right", "left"});
  const auto text = [&](const char* key) {
    return node.has(key) ? named_column(node.at(key)) : std::string();
  };
  PointSource point;
  point.x = text("x");
  point.y = text("y");
  point.theta = text("theta");
  point.body = text("body");
  point.marker = text("marker");
  point.right = text("right");
  point.left = text("left");
  const int sources = int(!point.x.empty() && !point.y.empty()) + int(!point.body.empty()) +
                      int(!point.marker.empty()) + int(!point.right.empty() && !point.left.empty());
  node.refuse_if(sources != 1,
                 "expected one of: x and y (columns of a CSV), body, marker, or right and left "
                 "(objects of a Motive file)");
  if (!point.body.empty()) {
    node.refuse_unknown_keys({"plate", "body"});
  } else if (!point.marker.empty()) {
    node.refuse_unknown_keys({"plate", "marker"});
  } else if (!point.right.empty() && !point.left.empty()) {
    node.refuse_unknown_keys({"plate", "right", "left"});
  } else {
    node.refuse_unknown_keys({"plate", "x", "y", "theta"});
  }
  return point;
}

std::vector<PointSource> read_points(const YamlReader& node, const ArmDescription& arm) {
  const std::vector<YamlReader> elements = node.elements();
  std::vector<PointSource> points = read_sources(elements, read_point);
  node.refuse_if(points.size() < 2, "{} points found; expected at least 2", points.size());
  number_plates(node, elements, arm, false, points);
  return points;
}

BaseAlignment read_alignment(const YamlReader& node) {
  BaseAlignment alignment;
  if (!node.is_mapping()) {
    if (node.text() != "base" && node.text() != "none") {
      node.refuse(
          fmt::format("{} found; expected base, none, {{straight_s: "
                      "[from, to]}} or {{x_m, y_m, heading_rad}}",
                      node.found()));
    }
    alignment.kind = node.text() == "base" ? BaseAlignment::Kind::base : BaseAlignment::Kind::none;
    return alignment;
  }
  node.refuse_unknown_keys({"straight_s", "x_m", "y_m", "heading_rad"});
  if (node.has("straight_s")) {
    const std::vector<double> times = node.at("straight_s").numbers("a time in s");
    if (times.size() != 2 || times[1] <= times[0]) {
      node.at("straight_s").refuse("expected [from, to] in s, rising");
    }
    alignment.kind = BaseAlignment::Kind::straight;
    alignment.straight_from_s = times[0];
    alignment.straight_to_s = times[1];
    return alignment;
  }
  alignment.kind = BaseAlignment::Kind::fixed;
  alignment.pose = {node.at("x_m").number("a length in metres"),
                    node.at("y_m").number("a length in metres"),
                    node.at("heading_rad").number("an angle in rad")};
  return alignment;
}

void read_layout(const YamlReader& root, ImportMapping& mapping) {
  if (root.has("separator")) {
    const YamlReader node = root.at("separator");
    const std::string text = node.text();
    if (text != "," && text != ";" && text != "tab" && text != "\t") {
      node.refuse(fmt::format("{} found; expected \",\", \";\" or tab", node.found()));
    }
    mapping.separator = text == "tab" ? '\t' : text.front();
  }
  if (root.has("decimal_comma")) {
    mapping.decimal_comma = root.at("decimal_comma").boolean();
    if (mapping.decimal_comma && mapping.separator == ',') {
      root.at("decimal_comma").refuse("a decimal comma needs another separator");
    }
  }
  if (root.has("skip_lines")) {
    mapping.skip_lines = root.at("skip_lines").integer("lines before the header", 0, 10000);
  }
  root.read_if_there("columns", mapping.columns, &YamlReader::texts);
}

void read_backbone(const YamlReader& node, const ArmDescription& arm, ImportMapping& mapping) {
  node.refuse_unknown_keys({"unit", "angle_unit", "headings", "up", "points"});
  if (node.has("unit")) {
    mapping.length_unit = node.at("unit").text();
    mapping.length_factor = factor_to(node.at("unit"), "m");
  }
  if (node.has("angle_unit")) {
    mapping.angle_factor = factor_to(node.at("angle_unit"), "rad");
  }
  node.read_if_there("headings", mapping.headings_measured, read_headings_measured);
  if (node.has("up")) {
    mapping.up = node.at("up").text();
    const std::string axis = mapping.up.starts_with('-') ? mapping.up.substr(1) : mapping.up;
    if (axis != "x" && axis != "y" && axis != "z") {
      node.at("up").refuse("expected x, y, z, -x, -y or -z: the axis that leaves the plane");
    }
  }
  if (node.has("points")) {
    mapping.points = read_points(node.at("points"), arm);
  }
}

}  // namespace

ImportMapping read_import_mapping(const fs::path& path, const ArmDescription& arm) {
  const YamlReader root = YamlReader::from_file(path);
  root.require_schema(kSchema);
  root.refuse_unknown_keys({"schema", "separator", "decimal_comma", "skip_lines", "columns", "time",
                            "recording", "motion", "pressures", "commands", "backbone", "alignment",
                            "longest_gap_s"});
  ImportMapping mapping = default_import_mapping(arm);
  read_layout(root, mapping);
  root.read_if_there("time", mapping.time, read_time);
  root.read_if_there("recording", mapping.recording, named_column);
  root.read_if_there("motion", mapping.motion, named_column);
  if (root.has("pressures") && root.has("commands")) {
    root.at("commands").refuse("stands beside pressures; a mapping has one of the two");
  }
  mapping.commands.time = mapping.time;
  for (const char* key : {"pressures", "commands"}) {
    if (root.has(key)) {
      mapping.commands = read_commands(root.at(key), key, arm, mapping.time);
    }
  }
  if (root.has("longest_gap_s")) {
    mapping.longest_gap_s.given_s =
        root.at("longest_gap_s").number("a time in s", 0.0, kLongestGap_s);
  }
  if (arm.is_spatial()) {
    read_space_mapping(root, arm, mapping);
    return mapping;
  }
  if (root.has("backbone")) {
    read_backbone(root.at("backbone"), arm, mapping);
  }
  root.read_if_there("alignment", mapping.alignment, read_alignment);
  const bool needs_base = mapping.alignment.kind == BaseAlignment::Kind::base ||
                          mapping.alignment.kind == BaseAlignment::Kind::straight;
  if (needs_base && !mapping.points.empty() && mapping.points.front().plate != 0) {
    root.at("backbone")
        .refuse(
            "no point is plate 0, the base; add it, or say where the base "
            "is: 'alignment: {x_m, y_m, heading_rad}' in the log's plane, "
            "or 'alignment: none' where the log is in the arm's frame");
  }
  return mapping;
}

}  // namespace limber
