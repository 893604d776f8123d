#include "limber/logs/import_mapping.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/import/1";
constexpr double kLongestGap_s = 10.0;

double factor_to(const YamlReader& node, const std::string& to) {
  const std::string from = node.text();
  const std::optional<double> factor = unit_factor(from, to);
  if (!factor) {
    node.refuse(fmt::format(
        "{} found; expected a unit that limber can turn into {}: lengths in m, cm, mm, in; angles "
        "in rad, deg; times in s, ms, us, ns, min; pressures in kPa, Pa, hPa, mbar, bar, MPa, psi",
        node.found(), to));
  }
  return *factor;
}

TimeColumn read_time(const YamlReader& node) {
  node.refuse_unknown_keys({"column", "unit", "rate_hz"});
  TimeColumn time;
  time.column = node.at("column").text();
  if (node.has("unit")) {
    time.unit = node.at("unit").text();
  }
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
    const std::string name = element.text();
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      element.refuse(fmt::format("'{}' is named twice", name));
    }
    names.push_back(name);
  }
  if (names.size() != count) {
    node.refuse(fmt::format("{} columns found; expected {}, {}", names.size(), count, each));
  }
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

CommandColumns read_commands(const YamlReader& node, const std::string& key,
                             const ArmDescription& arm, const TimeColumn& time) {
  node.refuse_unknown_keys(
      {"unit", "of", "columns", "right", "left", "setpoints", "measured", "time"});
  CommandColumns commands;
  commands.summed = read_summed(node, arm);
  const std::size_t n = commands.summed ? arm.commands.size() : arm.segments.size();
  const std::string each =
      commands.summed
          ? fmt::format("one for each command of arm '{}', in its file's order", arm.name)
          : fmt::format(
                "one for each segment of arm '{}', base first. If they are commands of the "
                "arm's own, limber characterize --commands finds what they act on",
                arm.name);
  commands.time = node.has("time") ? read_time(node.at("time")) : time;
  commands.unit = node.has("unit") ? node.at("unit").text() : arm.command.unit;
  if (node.has("unit")) {
    commands.factor = factor_to(node.at("unit"), arm.command.unit);
  }
  for (const char* side : {"right", "left"}) {
    if (commands.summed && node.has(side)) {
      node.at(side).refuse(
          "the arm's file has 'commands', which are signed: expected 'columns', one for each");
    }
  }
  const bool sided = node.has("right") && node.has("left");
  const bool setpoints_alone =
      node.has("setpoints") && !node.has("columns") && !node.has("right") && !node.has("left");
  if (node.has("columns") == sided && !setpoints_alone) {
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
  return commands;
}

PointSource read_point(const YamlReader& node) {
  node.refuse_unknown_keys({"plate", "x", "y", "theta", "body", "marker", "right", "left"});
  const auto text = [&](const char* key) {
    return node.has(key) ? node.at(key).text() : std::string();
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
  if (sources != 1) {
    node.refuse(
        "expected one of: x and y (columns of a CSV), body, marker, or right and left "
        "(objects of a Motive file)");
  }
  return point;
}

/// Every point's plate: given, or counted where every plate has a point.
void number_plates(const YamlReader& node, const std::vector<YamlReader>& elements,
                   const ArmDescription& arm, std::vector<PointSource>& points) {
  const int last = arm.point_count() - 1;
  const bool all = static_cast<int>(points.size()) == arm.point_count();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (elements[i].has("plate")) {
      points[i].plate = elements[i].at("plate").integer("a plate of the arm, 0 the base", 0, last);
    } else if (all) {
      points[i].plate = static_cast<int>(i);
    } else {
      node.refuse(
          fmt::format("{} points found; arm '{}' has {} plates: say which plate each point "
                      "is, as in {{plate: 0, …}}, 0 the base, {} the end",
                      points.size(), arm.name, arm.point_count(), last));
    }
    if (i > 0 && points[i].plate <= points[i - 1].plate) {
      elements[i].refuse(fmt::format("{} after {}; expected rising plates, base first",
                                     plate_name(points[i].plate), plate_name(points[i - 1].plate)));
    }
  }
  if (points.back().plate != last) {
    node.refuse(
        fmt::format("the last point is {}; expected {}, the arm's end: what lies beyond the last "
                    "point can't be interpolated. Describe an arm that ends where it is tracked",
                    plate_name(points.back().plate), plate_name(last)));
  }
}

std::vector<PointSource> read_points(const YamlReader& node, const ArmDescription& arm) {
  std::vector<PointSource> points;
  const std::vector<YamlReader> elements = node.elements();
  for (const YamlReader& element : elements) {
    points.push_back(read_point(element));
    const PointSource& p = points.back();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const PointSource& q = points[i];
      const bool same = !p.x.empty() ? (p.x == q.x && p.y == q.y)
                                     : (p.body == q.body && p.marker == q.marker &&
                                        p.right == q.right && p.left == q.left);
      if (same) {
        element.refuse(fmt::format("the same source as {} before it", point_name(i)));
      }
    }
  }
  if (points.size() < 2) {
    node.refuse(fmt::format("{} points found; expected at least 2", points.size()));
  }
  number_plates(node, elements, arm, points);
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
  if (root.has("columns")) {
    for (const YamlReader& element : root.at("columns").elements()) {
      mapping.columns.push_back(element.text());
    }
  }
}

void read_headings(const YamlReader& node, ImportMapping& mapping) {
  if (node.text() != "measured" && node.text() != "tangent") {
    node.refuse(fmt::format("{} found; expected measured or tangent", node.found()));
  }
  mapping.headings_measured = node.text() == "measured";
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
  if (node.has("headings")) {
    read_headings(node.at("headings"), mapping);
  }
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

ImportMapping read_import_mapping(const std::filesystem::path& path, const ArmDescription& arm) {
  const YamlReader root = YamlReader::from_file(path);
  root.require_schema(kSchema);
  root.refuse_unknown_keys({"schema", "separator", "decimal_comma", "skip_lines", "columns", "time",
                            "recording", "motion", "pressures", "commands", "backbone", "alignment",
                            "longest_gap_s"});
  ImportMapping mapping = default_import_mapping(arm);
  read_layout(root, mapping);
  if (root.has("time")) {
    mapping.time = read_time(root.at("time"));
  }
  if (root.has("recording")) {
    mapping.recording = root.at("recording").text();
  }
  if (root.has("motion")) {
    mapping.motion = root.at("motion").text();
  }
  for (const char* key : {"pressures", "commands"}) {
    if (root.has(key)) {
      mapping.commands = read_commands(root.at(key), key, arm, mapping.time);
    }
  }
  if (root.has("backbone")) {
    read_backbone(root.at("backbone"), arm, mapping);
  }
  if (root.has("alignment")) {
    mapping.alignment = read_alignment(root.at("alignment"));
  }
  const bool needs_base = mapping.alignment.kind == BaseAlignment::Kind::base ||
                          mapping.alignment.kind == BaseAlignment::Kind::straight;
  if (needs_base && !mapping.points.empty() && mapping.points.front().plate != 0) {
    root.at("backbone")
        .refuse(
            "no point is plate 0, the base; add it, or say where the base "
            "is: 'alignment: {x_m, y_m, heading_rad}' in the log's plane, "
            "or 'alignment: none' where the log is in the arm's frame");
  }
  if (root.has("longest_gap_s")) {
    mapping.longest_gap_s = root.at("longest_gap_s").number("a time in s", 0.0, kLongestGap_s);
  }
  return mapping;
}

}  // namespace limber
