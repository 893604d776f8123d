#include "space_segments.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/space_no_load.hpp"
#include "limber/common/yaml_reader.hpp"
#include "segment_reader.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxChambers = 16;  // of a segment

Eigen::Vector3d read_gravity(const YamlReader& node) {
  const std::vector<double> numbers = node.numbers("a part of gravity's direction");
  node.refuse_if(
      numbers.size() != 3,
      "{} numbers found; expected 3, where things fall in the frame of the base: [1, 0, 0] for "
      "an arm that hangs, [-1, 0, 0] for one that stands upright",
      numbers.size());
  const Eigen::Vector3d direction(numbers[0], numbers[1], numbers[2]);
  node.refuse_if(!(direction.norm() > 0.0),
                 "[0, 0, 0] found; expected a direction, or no such key");
  constexpr double kUnit = 1e-9;  // what is one already keeps its bits
  return std::abs(direction.norm() - 1.0) < kUnit ? direction : direction.normalized();
}

/// Reads segments of one arm.
class SpaceSegmentReader : private SegmentPartReader {
 public:
  using SegmentPartReader::SegmentPartReader;

  Segment read(const YamlReader& node) const {
    node.refuse_unknown_keys({"length_m", "width_m", "gaps", "chambers", "shape_of_strains"});
    Segment segment = read_sizes(node);
    const YamlReader chambers = node.at("chambers");
    for (const YamlReader& chamber : chambers.elements()) {
      segment.chambers.push_back(read_chamber(chamber));
    }
    chambers.refuse_if(segment.chambers.empty() || segment.chambers.size() > kMaxChambers,
                       "{} chambers found; expected 1 to {}", segment.chambers.size(),
                       kMaxChambers);
    return segment;
  }

  /// The matrix of a `fitted` arm of `channels` chambers in all.
  Eigen::MatrixXd read_shape(const YamlReader& node, int channels) const {
    const char* const key = "shape_of_strains";
    if (kind_ != NoLoadKind::fitted) {
      if (node.has(key)) {
        node.at(key).refuse("belongs to 'no_load: fitted'; expected no such key here");
      }
      return {};
    }
    if (polynomials_ == PolynomialsOf::characterisation && !node.has(key)) {
      return Eigen::MatrixXd::Zero(kShapeRows, channels);
    }
    const YamlReader matrix = node.at(key);
    const std::vector<YamlReader> rows = matrix.elements();
    Eigen::MatrixXd result(kShapeRows, channels);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<double> row = rows[i].numbers("a share of a chamber's strain");
      matrix.refuse_if(
          rows.size() != kShapeRows || row.size() != std::size_t(channels),
          "{} rows, one of {} numbers, found; expected 3, bend about y and about z [rad] and "
          "extension [share of length_m], of {} numbers, one for each chamber of the arm "
          "('limber characterize --recording' fits them)",
          rows.size(), row.size(), channels);
      result.row(Eigen::Index(i)) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), channels);
    }
    matrix.refuse_if(rows.empty(), "no row found; expected 3");
    return result;
  }

 private:
  Chamber read_chamber(const YamlReader& node) const {
    node.refuse_unknown_keys({"angle_deg", "radius_m", "sense", limit_key(), "strain_polynomial"});
    Chamber chamber;
    const bool has_place = kind_ == NoLoadKind::chambers;
    if (has_place || node.has("angle_deg")) {
      chamber.angle_deg = node.at("angle_deg").number("degrees from y toward z", -360.0, 360.0);
    }
    if (has_place || node.has("radius_m")) {
      const YamlReader radius = node.at("radius_m");
      chamber.radius_m = read_radius_m(radius);
      radius.refuse_if(
          has_place && chamber.radius_m == 0.0,
          "0 found; expected the chamber's distance from the segment's axis in metres");
    }
    if (has_place || node.has("sense")) {
      chamber.sense = read_sense(node.at("sense"));
    }
    chamber.limit_kpa = read_limit(node);
    // An ideal chamber's strain has to be known; a fitted matrix can be one over commands.
    if ((has_place && polynomials_ == PolynomialsOf::model) || node.has("strain_polynomial")) {
      chamber.strain_polynomial =
          strain_polynomial_of(node, chamber.limit_kpa.largest_kpa(), polynomials_);
    }
    return chamber;
  }

  static int read_sense(const YamlReader& node) {
    if (node.text() != "extending" && node.text() != "contracting") {
      node.refuse(fmt::format("{} found; expected extending or contracting", node.found()));
    }
    return node.text() == "extending" ? 1 : -1;
  }
};

std::string chamber_to_yaml(const Chamber& chamber, const ArmDescription& arm) {
  std::string text =
      fmt::format("{{angle_deg: {}, radius_m: {}, sense: {}, {}: {}", chamber.angle_deg,
                  chamber.radius_m, chamber.sense > 0 ? "extending" : "contracting",
                  arm.command.is_pressure_kpa() ? "pressure_limit_kpa" : "limit",
                  limits_to_yaml(chamber.limit_kpa));
  if (chamber.strain_polynomial != StrainPolynomial{}) {
    text += fmt::format(", strain_polynomial: [{}]", fmt::join(chamber.strain_polynomial, ", "));
  }
  return text + "}";
}

}  // namespace

void read_space_segments(const YamlReader& root, PolynomialsOf polynomials, ArmDescription& arm) {
  root.read_if_there("gravity", arm.gravity, read_gravity);
  const SpaceSegmentReader reader(root, arm, polynomials);
  const std::vector<YamlReader> nodes = root.at("segments").elements();
  for (const YamlReader& node : nodes) {
    arm.segments.push_back(reader.read(node));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    arm.segments[i].shape_of_strains = reader.read_shape(nodes[i], arm.channel_count());
  }
}

std::string space_segment_to_yaml(const Segment& segment, const ArmDescription& arm) {
  std::string text = fmt::format("{{length_m: {}, width_m: {}, gaps: {}, chambers: [",
                                 segment.length_m, segment.width_m, segment.gaps);
  for (std::size_t i = 0; i < segment.chambers.size(); ++i) {
    text +=
        fmt::format("{}\n      {}", i == 0 ? "" : ",", chamber_to_yaml(segment.chambers[i], arm));
  }
  text += "]";
  if (arm.no_load == NoLoadKind::fitted) {
    text += ", shape_of_strains: [";
    for (Eigen::Index i = 0; i < segment.shape_of_strains.rows(); ++i) {
      const Eigen::RowVectorXd row = segment.shape_of_strains.row(i);
      text += fmt::format("{}\n      [{}]", i == 0 ? "" : ",", fmt::join(row, ", "));
    }
    text += "]";
  }
  return text + "}";
}

}  // namespace limber
