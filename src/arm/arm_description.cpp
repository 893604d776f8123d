#include "limber/arm/arm_description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

constexpr const char* kSchema = "limber/arm/1";
constexpr int kMostGaps = 100;

Segment read_segment(const YamlReader& node) {
  node.refuse_unknown_keys(
      {"length_m", "width_m", "gaps", "pressure_limit_kpa", "strain_polynomial"});
  Segment segment;
  segment.length_m = node.at("length_m").positive("a length in metres");
  segment.width_m = node.at("width_m").positive("a length in metres");
  segment.gaps = node.at("gaps").integer("a number of gaps between plates", 1, kMostGaps);
  segment.pressure_limit_kpa = node.at("pressure_limit_kpa").positive("a gauge pressure in kPa");
  const YamlReader polynomial = node.at("strain_polynomial");
  const std::vector<double> coefficients = polynomial.numbers("a coefficient c1 … c4 for kPa");
  if (coefficients.size() != segment.strain_polynomial.size()) {
    polynomial.refuse(fmt::format(
        "{} coefficients found; expected 4: c1 … c4 of e = c1 p + c2 p² + c3 p³ + c4 p⁴",
        coefficients.size()));
  }
  std::copy(coefficients.begin(), coefficients.end(), segment.strain_polynomial.begin());
  const std::string reason = why_unusable(segment.strain_polynomial, segment.pressure_limit_kpa);
  if (!reason.empty()) {
    polynomial.refuse(reason);
  }
  return segment;
}

std::string segment_to_yaml(const Segment& s) {
  return fmt::format(
      "{{length_m: {}, width_m: {}, gaps: {}, pressure_limit_kpa: {},\n     strain_polynomial: "
      "[{}]}}",
      s.length_m, s.width_m, s.gaps, s.pressure_limit_kpa, fmt::join(s.strain_polynomial, ", "));
}

/// A text as one line of YAML that reads back the same, whatever it holds.
std::string quoted(const std::string& text) {
  YAML::Emitter emitter;
  emitter.SetStringFormat(YAML::DoubleQuoted);
  emitter << text;
  return emitter.c_str();
}

}  // namespace

int ArmDescription::point_count() const {
  int count = 1;
  for (const Segment& segment : segments) {
    count += segment.gaps;
  }
  return count;
}

double ArmDescription::length_m() const {
  double sum = 0.0;
  for (const Segment& segment : segments) {
    sum += segment.length_m;
  }
  return sum;
}

int ArmDescription::segment_of_gap(int gap) const {
  int segment = 0;
  while (gap >= segments[static_cast<std::size_t>(segment)].gaps) {
    gap -= segments[static_cast<std::size_t>(segment)].gaps;
    ++segment;
  }
  return segment;
}

std::string ArmDescription::hash() const {
  std::string text =
      fmt::format("{} {} {}", frame_rate_hz, pressure_rate_limit_kpa_per_s, actuator_radius_m);
  for (const Segment& segment : segments) {
    text += segment_to_yaml(segment);
  }
  return content_hash(text);
}

ArmDescription read_arm(const YamlReader& root) {
  root.require_schema(kSchema);
  root.refuse_unknown_keys({"schema", "name", "frame_rate_hz", "pressure_rate_limit_kpa_per_s",
                            "actuator_radius_m", "segments", "virtual_arm"});
  ArmDescription arm;
  arm.name = root.at("name").text();
  if (arm.name.empty()) {
    root.at("name").refuse("an empty text found; expected a name");
  }
  arm.frame_rate_hz = root.at("frame_rate_hz").number("frames a second", 1.0, 1000.0);
  arm.pressure_rate_limit_kpa_per_s =
      root.at("pressure_rate_limit_kpa_per_s").positive("a pressure rate in kPa/s");
  arm.actuator_radius_m = root.at("actuator_radius_m").number("a length in metres", 0.0);
  const YamlReader segments = root.at("segments");
  for (const YamlReader& node : segments.elements()) {
    arm.segments.push_back(read_segment(node));
  }
  if (arm.segments.empty() || arm.segments.size() > kMostSegments) {
    segments.refuse(
        fmt::format("{} segments found; expected 1 to {}", arm.segments.size(), kMostSegments));
  }
  if (root.has("virtual_arm")) {
    arm.virtual_arm = read_virtual_arm_parameters(root.at("virtual_arm"));
  }
  return arm;
}

ArmDescription load_arm(const std::filesystem::path& path) {
  return read_arm(YamlReader::from_file(path));
}

std::string arm_to_yaml(const ArmDescription& arm) {
  std::string text = fmt::format(
      "schema: {}\nname: {}\nframe_rate_hz: {}\npressure_rate_limit_kpa_per_s: "
      "{}\nactuator_radius_m: {}\nsegments:\n",
      kSchema, quoted(arm.name), arm.frame_rate_hz, arm.pressure_rate_limit_kpa_per_s,
      arm.actuator_radius_m);
  for (const Segment& segment : arm.segments) {
    text += "  - " + segment_to_yaml(segment) + "\n";
  }
  return text + "virtual_arm:\n" + virtual_arm_parameters_to_yaml(arm.virtual_arm, 2);
}

std::string with_strain_polynomials(const std::string& yaml, const ArmDescription& arm) {
  const YAML::Node segments = YAML::Load(yaml)["segments"];
  std::string edited = yaml;
  for (std::size_t i = segments.size(); i-- > 0;) {  // from the end: earlier places stay valid
    const auto begin = std::size_t(segments[i]["strain_polynomial"].Mark().pos);
    const std::size_t end = edited.find(']', begin);
    if (begin < edited.size() && edited[begin] == '[' && end != std::string::npos) {
      edited.replace(begin, end - begin,
                     fmt::format("[{}", fmt::join(arm.segments[i].strain_polynomial, ", ")));
    }
  }
  try {
    if (arm_to_yaml(read_arm(YamlReader::from_text(edited, "the edited arm"))) ==
        arm_to_yaml(arm)) {
      return edited;
    }
  } catch (const InputError&) {
    // The edit hit something else: shared anchors, a bracket in a comment.
  }
  return arm_to_yaml(arm);
}

}  // namespace limber
