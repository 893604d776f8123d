#include "limber/arm/valve_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

constexpr const char* kValvesSchema = "limber/valves/1";

Json to_json(const SegmentValves& valves) {
  Json json = {{"inflate_time_constant_s", valves.inflating.time_constant_s},
               {"vent_time_constant_s", valves.venting.time_constant_s}};
  // JSON and YAML have no infinity: a missing key stands for it.
  if (std::isfinite(valves.inflating.rate_limit_kpa_per_s)) {
    json["inflate_rate_limit_kpa_per_s"] = valves.inflating.rate_limit_kpa_per_s;
  }
  if (std::isfinite(valves.venting.rate_limit_kpa_per_s)) {
    json["vent_rate_limit_kpa_per_s"] = valves.venting.rate_limit_kpa_per_s;
  }
  json["dead_time_s"] = valves.dead_time_s;
  json["dead_band_kpa"] = valves.dead_band_kpa;
  return json;
}

ValveDirection read_direction(const YamlReader& node, const std::string& name) {
  ValveDirection direction;
  direction.time_constant_s = node.at(name + "_time_constant_s").number("a time in seconds", 0.0);
  const std::string rate = name + "_rate_limit_kpa_per_s";
  direction.rate_limit_kpa_per_s =
      node.has(rate) ? node.at(rate).positive("a rate in kPa/s; leave it out for none")
                     : std::numeric_limits<double>::infinity();
  return direction;
}

SegmentValves read_segment(const YamlReader& node) {
  node.refuse_unknown_keys({"inflate_time_constant_s", "vent_time_constant_s",
                            "inflate_rate_limit_kpa_per_s", "vent_rate_limit_kpa_per_s",
                            "dead_time_s", "dead_band_kpa"});
  SegmentValves valves;
  valves.inflating = read_direction(node, "inflate");
  valves.venting = read_direction(node, "vent");
  valves.dead_time_s = node.at("dead_time_s").number("a time in seconds", 0.0, kLongestDeadTimeS);
  valves.dead_band_kpa = node.at("dead_band_kpa").number("a pressure in kPa", 0.0);
  return valves;
}

Json to_json(const ValveErrors& errors) {
  return {{"mean_kpa", errors.mean_kpa},
          {"p95_kpa", errors.p95_kpa},
          {"max_kpa", errors.max_kpa},
          {"frames", errors.frames}};
}

ValveErrors read_errors(const YamlReader& node) {
  node.refuse_unknown_keys({"mean_kpa", "p95_kpa", "max_kpa", "frames"});
  ValveErrors errors;
  errors.mean_kpa = node.at("mean_kpa").number("an error in kPa", 0.0);
  errors.p95_kpa = node.at("p95_kpa").number("an error in kPa", 0.0);
  errors.max_kpa = node.at("max_kpa").number("an error in kPa", 0.0);
  constexpr double kMaxFrames = 1e15;  // exact in a double
  errors.frames = std::llround(node.at("frames").number("a number of frames", 0.0, kMaxFrames));
  return errors;
}

Json to_json(const ValveFindings& findings) {
  Json json = {{"source", findings.source}};
  if (findings.held_back.frames > 0) {
    json["held_back_error"] = to_json(findings.held_back);
    json["setpoints_as_pressures_error"] = to_json(findings.from_setpoints);
  }
  if (!findings.reason.empty()) {
    json["reason"] = findings.reason;
  }
  json["warnings"] = findings.warnings;
  return json;
}

ValveFindings read_findings(const YamlReader& node) {
  node.refuse_unknown_keys(
      {"source", "held_back_error", "setpoints_as_pressures_error", "reason", "warnings"});
  ValveFindings findings;
  findings.source = node.at("source").text();
  node.read_if_there("held_back_error", findings.held_back, read_errors);
  node.read_if_there("setpoints_as_pressures_error", findings.from_setpoints, read_errors);
  node.read_if_there("reason", findings.reason, &YamlReader::text);
  node.read_if_there("warnings", findings.warnings, &YamlReader::texts);
  return findings;
}

std::string direction_to_text(const char* name, const ValveDirection& direction,
                              const std::string& unit) {
  std::string text = fmt::format("{} {:.3f} s", name, direction.time_constant_s);
  if (std::isfinite(direction.rate_limit_kpa_per_s)) {
    text += fmt::format(" at most {:.4g} {}/s", direction.rate_limit_kpa_per_s, unit);
  }
  return text;
}

std::string to_text(const SegmentValves& valves, bool has_sides, const std::string& unit) {
  return fmt::format("{}, {}, dead time {:.3f} s, dead band {:.3g} {}",
                     direction_to_text(has_sides ? "inflate" : "rise", valves.inflating, unit),
                     direction_to_text(has_sides ? "vent" : "fall", valves.venting, unit),
                     valves.dead_time_s, valves.dead_band_kpa, unit);
}

}  // namespace

Json to_json(const IdentifiedValves& valves) {
  const auto segments = mapped<Json>(
      valves.parameters.segments, [&](const SegmentValves& segment) { return to_json(segment); });
  return {{"schema", kValvesSchema},
          {"has_sides", valves.parameters.has_sides},
          {"segments", segments},
          {"identified", to_json(valves.findings)}};
}

std::string valves_to_yaml(const IdentifiedValves& valves) {
  const Json json = to_json(valves);
  // Values are written as JSON, which is YAML; keys without their quotes.
  const auto flow = [](const Json& mapping) {
    std::string text;
    for (const auto& [key, value] : mapping.items()) {
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", key, value.dump());
    }
    return "{" + text + "}";
  };
  std::string text =
      fmt::format("schema: {}\nhas_sides: {}\n", kValvesSchema, valves.parameters.has_sides);
  text += valves.parameters.is_ideal() ? "segments: []\n" : "segments:\n";
  for (const Json& segment : json.at("segments")) {
    text += "  - " + flow(segment) + "\n";
  }
  text += "identified:\n";
  for (const auto& [key, value] : json.at("identified").items()) {
    text += fmt::format("  {}: {}\n", key, value.is_object() ? flow(value) : value.dump());
  }
  return text;
}

std::string to_text(const IdentifiedValves& valves, const std::string& unit, Dimension dimension) {
  const ValveParameters& parameters = valves.parameters;
  if (parameters.is_ideal()) {
    return "valves: none known" +
           (valves.findings.reason.empty() ? "" : " (" + valves.findings.reason + ")");
  }
  const bool alike = std::ranges::all_of(parameters.segments, [&](const SegmentValves& segment) {
    return segment == parameters.segments.front();
  });
  std::string text = "valves: ";
  for (std::size_t i = 0; i < (alike ? 1 : parameters.segments.size()); ++i) {
    text +=
        (i > 0 ? "; " : "") +
        (alike ? std::string() : fmt::format("{}: ", channel_name(dimension, Eigen::Index(i)))) +
        to_text(parameters.segments[i], parameters.has_sides, unit);
  }
  const ValveErrors& errors = valves.findings.held_back;
  if (errors.frames > 0) {
    text += fmt::format("; held back: {:.3g} {} mean, {:.3g} p95, {:.3g} max (set points {:.3g})",
                        errors.mean_kpa, unit, errors.p95_kpa, errors.max_kpa,
                        valves.findings.from_setpoints.mean_kpa);
  }
  return text;
}

void write_valves(const fs::path& path, const IdentifiedValves& valves) {
  const ValveParameters& parameters = valves.parameters;
  const std::string fault = why_unusable(parameters, int(parameters.segments.size()));
  refuse_if(!fault.empty(), "{}: {}", path.string(), fault);
  write_file_atomically(path, valves_to_yaml(valves));
}

IdentifiedValves read_valves(const fs::path& path) {
  return read_valves(YamlReader::from_file(path));
}

IdentifiedValves read_valves(const YamlReader& root) {
  root.require_schema(kValvesSchema);
  root.refuse_unknown_keys({"schema", "has_sides", "segments", "identified"});
  IdentifiedValves valves;
  valves.parameters.has_sides = root.at("has_sides").boolean();
  for (const YamlReader& node : root.at("segments").elements()) {
    valves.parameters.segments.push_back(read_segment(node));
  }
  root.read_if_there("identified", valves.findings, read_findings);
  return valves;
}

}  // namespace limber
