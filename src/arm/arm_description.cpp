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

StrainPolynomial read_strain_polynomial(const YamlReader& node, double pressure_limit_kpa) {
  const std::vector<double> coefficients = node.numbers("a coefficient c1 … c4 for kPa");
  StrainPolynomial polynomial{};
  if (coefficients.size() != polynomial.size()) {
    node.refuse(fmt::format(
        "{} coefficients found; expected 4: c1 … c4 of e = c1 p + c2 p² + c3 p³ + c4 p⁴ "
        "('limber characterize' fits them)",
        coefficients.size()));
  }
  std::copy(coefficients.begin(), coefficients.end(), polynomial.begin());
  const std::string reason = why_unusable(polynomial, pressure_limit_kpa);
  if (!reason.empty()) {
    node.refuse(reason);
  }
  return polynomial;
}

Segment read_segment(const YamlReader& node, PolynomialsOf polynomials) {
  node.refuse_unknown_keys(
      {"length_m", "width_m", "gaps", "pressure_limit_kpa", "strain_polynomial"});
  Segment segment;
  segment.length_m = node.at("length_m").positive("a length in metres");
  segment.width_m = node.at("width_m").positive("a length in metres");
  segment.gaps = node.at("gaps").integer("a number of gaps between plates", 1, kMostGaps);
  segment.pressure_limit_kpa = node.at("pressure_limit_kpa").positive("a gauge pressure in kPa");
  if (polynomials == PolynomialsOf::model) {
    segment.strain_polynomial =
        read_strain_polynomial(node.at("strain_polynomial"), segment.pressure_limit_kpa);
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

int ArmDescription::frames_in(double seconds) const {
  constexpr double kRounding = 1e-9;  // 0.15 s at 20 Hz are three frames
  return static_cast<int>(std::ceil(seconds * frame_rate_hz - kRounding));
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

ArmDescription read_arm(const YamlReader& root, PolynomialsOf polynomials) {
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
    arm.segments.push_back(read_segment(node, polynomials));
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

ArmDescription load_arm(const std::filesystem::path& path, PolynomialsOf polynomials) {
  return read_arm(YamlReader::from_file(path), polynomials);
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
  read_arm(YamlReader::from_text(yaml, "the arm file"), PolynomialsOf::characterisation);
  const YAML::Node segments = YAML::Load(yaml)["segments"];
  std::string edited = yaml;
  // From the end: earlier places stay valid.
  for (std::size_t i = std::min(segments.size(), arm.segments.size()); i-- > 0;) {
    const YAML::Node polynomial = segments[i]["strain_polynomial"];
    if (!polynomial) {
      continue;
    }
    const auto begin = std::size_t(polynomial.Mark().pos);
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
