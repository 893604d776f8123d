#include "limber/arm/arm_description.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arm_commands_file.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "segment_reader.hpp"
#include "space_segments.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/arm/1";

Dimension read_dimension(const YamlReader& root) {
  return root.has("dimension") &&
                 root.at("dimension").integer("2, in a plane, or 3, in space", 2, 3) == 3
             ? Dimension::space
             : Dimension::plane;
}

NoLoadKind read_no_load(const YamlReader& root, Dimension dimension) {
  const std::vector<NoLoadKind> kinds =
      dimension == Dimension::space
          ? std::vector{NoLoadKind::chambers, NoLoadKind::fitted, NoLoadKind::straight}
          : std::vector{NoLoadKind::strain_polynomial, NoLoadKind::curvature, NoLoadKind::straight};
  if (!root.has("no_load")) {
    return kinds.front();
  }
  const YamlReader node = root.at("no_load");
  for (const NoLoadKind kind : kinds) {
    if (node.text() == to_string(kind)) {
      return kind;
    }
  }
  node.refuse(fmt::format("{} found; expected {}, {} or {}{}", node.found(), to_string(kinds[0]),
                          to_string(kinds[1]), to_string(kinds[2]),
                          dimension == Dimension::space ? " for an arm in space" : ""));
}

Command read_command(const YamlReader& node) {
  node.refuse_unknown_keys({"name", "unit", "limit", "rate_limit_per_s"});
  Command command{node.at("name").text(), node.at("unit").text()};
  node.refuse_if(command.name.empty() || command.unit.empty(),
                 "an empty name or unit found; expected words such as 'motor angle' and 'rad'");
  return command;
}

std::string segment_to_yaml(const Segment& s, const ArmDescription& arm) {
  if (arm.is_spatial()) {
    return space_segment_to_yaml(s, arm);
  }
  std::string text =
      fmt::format("{{length_m: {}, width_m: {}, gaps: {}, {}: {}", s.length_m, s.width_m, s.gaps,
                  arm.command.is_pressure_kpa() ? "pressure_limit_kpa" : "limit",
                  limits_to_yaml(s.pressure_limit_kpa));
  if (arm.no_load == NoLoadKind::strain_polynomial) {
    text += fmt::format(",\n     strain_polynomial: [{}]", fmt::join(s.strain_polynomial, ", "));
  }
  if (arm.no_load == NoLoadKind::curvature) {
    text += fmt::format(", curvature_per_unit: {}", s.curvature_per_unit);
  }
  return text + "}";
}

bool is_plain(const ArmDescription& arm) {
  return !arm.is_spatial() && arm.command.is_pressure_kpa() &&
         arm.no_load == NoLoadKind::strain_polynomial;
}

void read_command_and_rate(const YamlReader& root, ArmDescription& arm) {
  if (root.has("pressure_rate_limit_kpa_per_s")) {
    root.at("pressure_rate_limit_kpa_per_s")
        .refuse("an arm with 'command' has its rate in command.rate_limit_per_s");
  }
  const YamlReader node = root.at("command");
  arm.command = read_command(node);
  arm.pressure_rate_limit_kpa_per_s =
      node.at("rate_limit_per_s").positive(fmt::format("a rate in {}/s", arm.command.unit));
}

/// So slow that no motion ends: a unit was mistaken, and counts of frames would overflow.
void require_usable_rate(const YamlReader& root, const ArmDescription& arm) {
  if (arm.max_motion_frames() > kMaxMotionFrames) {
    const YamlReader node = root.has("command") ? root.at("command").at("rate_limit_per_s")
                                                : root.at("pressure_rate_limit_kpa_per_s");
    node.refuse(fmt::format(
        "{} found; expected a rate at which a command gets from limit to limit within {:.0f} "
        "frames",
        arm.pressure_rate_limit_kpa_per_s, kMaxMotionFrames));
  }
}

std::string schema_line() {
  return fmt::format("schema: {}\n", kSchema);
}

}  // namespace

int ArmDescription::channel_count() const {
  return sum_of<int>(segments, [&](const Segment& segment) {
    return is_spatial() ? int(segment.chambers.size()) : 1;
  });
}

const Chamber& ArmDescription::chamber(int channel) const {
  std::size_t segment = 0;
  auto at = std::size_t(channel);
  while (at >= segments[segment].chambers.size()) {
    at -= segments[segment++].chambers.size();
  }
  return segments[segment].chambers[at];
}

const PressureLimits& ArmDescription::limits_of_channel(int channel) const {
  return is_spatial() ? chamber(channel).limit_kpa : segments[channel].pressure_limit_kpa;
}

int ArmDescription::point_count() const {
  int count = 1;
  for (const Segment& segment : segments) {
    count += segment.gaps;
  }
  return count;
}

double ArmDescription::length_m() const {
  return sum_of<double>(segments, [&](const Segment& segment) { return segment.length_m; });
}

int ArmDescription::frames_in(double seconds) const {
  constexpr double kRounding = 1e-9;  // 0.15 s at 20 Hz are three frames
  return int(std::ceil(seconds * frame_rate_hz - kRounding));
}

int ArmDescription::segment_of_gap(int gap) const {
  int segment = 0;
  while (gap >= segments[segment].gaps) {
    gap -= segments[segment].gaps;
    ++segment;
  }
  return segment;
}

double ArmDescription::max_motion_frames() const {
  double widest = 0.0;
  for (int i = 0; i < channel_count(); ++i) {
    widest = std::max(widest, 2.0 * limits_of_channel(i).half_width_kpa());
  }
  return widest / pressure_step_limit_kpa();
}

std::string ArmDescription::hash() const {
  std::string text =
      fmt::format("{} {} {}", frame_rate_hz, pressure_rate_limit_kpa_per_s, actuator_radius_m);
  // Arms without the keys that came later keep the hash that they had before.
  if (!is_plain(*this)) {
    text += fmt::format(" {} {} {}", command.name, command.unit, to_string(no_load));
  }
  if (is_spatial()) {
    text += fmt::format(" {}", fmt::join(gravity, " "));
  }
  for (const Segment& segment : segments) {
    text += segment_to_yaml(segment, *this);
  }
  for (const ArmCommand& one : commands) {
    text += fmt::format(" {}", fmt::join(one.shares, " "));
  }
  return content_hash(text);
}

const char* to_string(NoLoadKind kind) {
  constexpr std::array kNames = {"strain_polynomial", "curvature", "straight", "chambers",
                                 "fitted"};  // in the order of NoLoadKind
  return kNames[std::size_t(kind)];
}

void require_planar(const ArmDescription& arm, const std::string& what) {
  refuse_if(
      arm.is_spatial(),
      "{} can't use an arm in space yet, and '{}' is one. collect, import, inspect, "
      "characterize --recording and --valves, train, family, adapt, evaluate, export and bench can",
      what, arm.name);
}

void require_pressure_driven(const ArmDescription& arm, const std::string& what) {
  refuse_if(!arm.command.is_pressure_kpa(),
            "{} needs an arm that is driven by pressures in kPa; arm '{}' is driven by '{}' in {}. "
            "Record it on its hardware and bring the logs with 'limber import'",
            what, arm.name, arm.command.name, arm.command.unit);
}

ArmDescription read_arm(const YamlReader& root, PolynomialsOf polynomials) {
  root.require_schema(kSchema);
  root.refuse_unknown_keys({"schema", "name", "dimension", "command", "no_load", "frame_rate_hz",
                            "pressure_rate_limit_kpa_per_s", "actuator_radius_m", "gravity",
                            "segments", "commands", "virtual_arm", "safety"});
  ArmDescription arm;
  arm.dimension = read_dimension(root);
  arm.name = root.at("name").text();
  if (arm.name.empty()) {
    root.at("name").refuse("an empty text found; expected a name");
  }
  arm.frame_rate_hz = root.at("frame_rate_hz").number("frames per second", 1.0, 1000.0);
  arm.no_load = read_no_load(root, arm.dimension);
  if (root.has("command")) {
    read_command_and_rate(root, arm);
  } else {
    arm.pressure_rate_limit_kpa_per_s =
        root.at("pressure_rate_limit_kpa_per_s").positive("a pressure rate in kPa/s");
  }
  arm.actuator_radius_m = read_radius_m(root.at("actuator_radius_m"));
  const YamlReader segments = root.at("segments");
  const std::vector<YamlReader> nodes = segments.elements();
  segments.refuse_if(nodes.empty() || nodes.size() > kMaxSegments,
                     "{} segments found; expected 1 to {}", nodes.size(), kMaxSegments);
  if (arm.is_spatial()) {
    read_space_segments(root, polynomials, arm);
  } else {
    if (root.has("gravity")) {
      root.at("gravity").refuse("an arm in a plane lies on a table; expected no such key");
    }
    const SegmentReader reader(root, arm, polynomials);
    for (const YamlReader& node : nodes) {
      arm.segments.push_back(reader.read(node));
    }
  }
  require_usable_rate(root, arm);
  if (root.has("commands")) {
    arm.commands = read_arm_commands(root.at("commands"), arm);
  }
  if (root.has("virtual_arm")) {
    if (!arm.command.is_pressure_kpa()) {
      root.at("virtual_arm")
          .refuse(
              "the virtual arm is driven by pressures in kPa; leave the key "
              "out for an arm of another command");
    }
    arm.virtual_arm = {root.mapping_as_text("virtual_arm"), root.file()};
  }
  if (root.has("safety")) {
    arm.safety_yaml = root.mapping_as_text("safety");
  }
  return arm;
}

ArmDescription load_arm(const fs::path& path, PolynomialsOf polynomials) {
  return read_arm(YamlReader::from_file(path), polynomials);
}

std::string arm_to_yaml(const ArmDescription& arm) {
  std::string text = schema_line() + arm_keys_to_yaml(arm);
  for (const std::string& section : {arm.virtual_arm.yaml, arm.safety_yaml}) {
    text += section.substr(std::min(section.find_first_not_of('\n'), section.size()));
  }
  return text;
}

ArmDescription read_arm_keys(const std::string& keys, const std::string& name,
                             PolynomialsOf polynomials) {
  return read_arm(YamlReader::from_text(schema_line() + keys, name), polynomials);
}

std::string arm_keys_to_yaml(const ArmDescription& arm) {
  const bool pressures = arm.command.is_pressure_kpa();
  std::string text = fmt::format("name: {}\n", yaml_text(arm.name));
  if (arm.is_spatial()) {
    text += "dimension: 3\n";
  }
  if (!pressures) {
    text +=
        fmt::format("command: {{name: {}, unit: {}, limit: {}, rate_limit_per_s: {}}}\n",
                    yaml_text(arm.command.name), yaml_text(arm.command.unit),
                    limits_to_yaml(arm.limits_of_channel(0)), arm.pressure_rate_limit_kpa_per_s);
  }
  if (arm.no_load != NoLoadKind::strain_polynomial) {
    text += fmt::format("no_load: {}\n", to_string(arm.no_load));
  }
  text += fmt::format("frame_rate_hz: {}\n", arm.frame_rate_hz);
  if (pressures) {
    text += fmt::format("pressure_rate_limit_kpa_per_s: {}\n", arm.pressure_rate_limit_kpa_per_s);
  }
  text += fmt::format("actuator_radius_m: {}\n", arm.actuator_radius_m);
  if (!arm.gravity.isZero(0.0)) {
    text += fmt::format("gravity: [{}]\n", fmt::join(arm.gravity, ", "));
  }
  text += "segments:\n";
  for (const Segment& segment : arm.segments) {
    text += "  - " + segment_to_yaml(segment, arm) + "\n";
  }
  return text + arm_commands_to_yaml(arm.commands);
}

std::vector<double> rest_positions_m(const ArmDescription& arm) {
  std::vector<double> positions = {0.0};
  for (const Segment& segment : arm.segments) {
    for (int gap = 0; gap < segment.gaps; ++gap) {
      positions.push_back(positions.back() + segment.length_m / segment.gaps);
    }
  }
  return positions;
}

}  // namespace limber
