#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

inline constexpr double kMaxLength_m = 10.0;  ///< of a segment, or its width
inline constexpr double kMaxRadius_m = 1.0;   ///< of an actuator

/// A length > 0. @throws InputError also beyond kMaxLength_m, where it may be in millimetres.
inline double read_length_m(const YamlReader& node) {
  const double length_m = node.positive("a length in metres");
  node.refuse_if(length_m > kMaxLength_m,
                 "{} found; expected a length in metres, > 0 and at most {}. Is it in millimetres?",
                 length_m, kMaxLength_m);
  return length_m;
}

/// A radius >= 0. @throws InputError also beyond kMaxRadius_m.
inline double read_radius_m(const YamlReader& node) {
  const double radius_m = node.number("a length in metres", 0.0);
  node.refuse_if(radius_m > kMaxRadius_m,
                 "{} found; expected a length in metres, from 0 to {}. Is it in millimetres?",
                 radius_m, kMaxRadius_m);
  return radius_m;
}

inline constexpr int kMaxGaps = 100;  ///< of a segment

inline StrainPolynomial read_coefficients(const YamlReader& node) {
  const std::vector<double> coefficients = node.numbers("a coefficient c1 … c4 for kPa");
  StrainPolynomial polynomial{};
  node.refuse_if(coefficients.size() != polynomial.size(),
                 "{} coefficients found; expected 4: c1 … c4 of e = c1 p + c2 p² + c3 p³ + c4 p⁴ "
                 "('limber characterize' fits them)",
                 coefficients.size());
  std::copy(coefficients.begin(), coefficients.end(), polynomial.begin());
  return polynomial;
}

inline StrainPolynomial read_strain_polynomial(const YamlReader& node, double pressure_limit_kpa) {
  const StrainPolynomial polynomial = read_coefficients(node);
  const std::string reason = why_unusable(polynomial, pressure_limit_kpa);
  if (!reason.empty()) {
    node.refuse(reason);
  }
  return polynomial;
}

/// A segment's or chamber's. @return zero where it is missing, or none that a model can use, and
/// characterisation asks
inline StrainPolynomial strain_polynomial_of(const YamlReader& part, double pressure_limit_kpa,
                                             PolynomialsOf polynomials) {
  try {
    return read_strain_polynomial(part.at("strain_polynomial"), pressure_limit_kpa);
  } catch (const InputError&) {
    if (polynomials == PolynomialsOf::model) {
      throw;
    }
    return {};
  }
}

/// Reads what segments have alike in the plane and in space. What they may say depends on the arm's
/// command.
class SegmentPartReader {
 public:
  SegmentPartReader(const YamlReader& root, const ArmDescription& arm, PolynomialsOf polynomials)
      : kind_(arm.no_load), unit_(arm.command.unit), polynomials_(polynomials) {
    if (root.has("command")) {
      general_limit_ = read_limits(root.at("command").at("limit"), limit_meaning());
    }
  }

 protected:
  static Segment read_sizes(const YamlReader& node) {
    Segment segment;
    segment.length_m = read_length_m(node.at("length_m"));
    segment.width_m = read_length_m(node.at("width_m"));
    segment.gaps = node.at("gaps").integer("the number of gaps between plates", 1, kMaxGaps);
    return segment;
  }

  const char* limit_key() const { return general_limit_ ? "limit" : "pressure_limit_kpa"; }

  /// Of a segment or a chamber.
  PressureLimits read_limit(const YamlReader& node) const {
    if (!general_limit_) {
      return read_limits(node.at(limit_key()), "a gauge pressure in kPa");
    }
    return node.has(limit_key()) ? read_limits(node.at(limit_key()), limit_meaning())
                                 : *general_limit_;
  }

  NoLoadKind kind_;
  std::string unit_;
  PolynomialsOf polynomials_;

 private:
  std::string limit_meaning() const { return fmt::format("a limit of the command in {}", unit_); }

  std::optional<PressureLimits> general_limit_;
};

/// Reads segments of one arm in the plane.
class SegmentReader : private SegmentPartReader {
 public:
  using SegmentPartReader::SegmentPartReader;

  Segment read(const YamlReader& node) const {
    std::vector<std::string> allowed = {"length_m", "width_m", "gaps", limit_key()};
    if (kind_ != NoLoadKind::straight) {
      allowed.push_back(kind_ == NoLoadKind::curvature ? "curvature_per_unit"
                                                       : "strain_polynomial");
    }
    node.refuse_unknown_keys(allowed);
    Segment segment = read_sizes(node);
    segment.pressure_limit_kpa = read_limit(node);
    if (kind_ == NoLoadKind::strain_polynomial) {
      read_polynomial(node, segment);
    }
    if (kind_ == NoLoadKind::curvature) {
      read_curvature(node, segment);
    }
    return segment;
  }

 private:
  void read_polynomial(const YamlReader& node, Segment& segment) const {
    const double limit = segment.pressure_limit_kpa.largest_kpa();
    segment.strain_polynomial = strain_polynomial_of(node, limit, polynomials_);
    const double turn_rad =
        strain_at(segment.strain_polynomial, limit) * segment.length_m / segment.width_m;
    if (turn_rad <= segment.gaps * kMaxTurnOfGap_rad) {
      return;
    }
    if (polynomials_ == PolynomialsOf::model) {
      node.at("width_m").refuse(fmt::format(
          "{} m found, and so {} {} turn the segment by {:.1f} rad; expected less than half a turn "
          "for each of its {} gaps",
          segment.width_m, limit, unit_, turn_rad, segment.gaps));
    }
    segment.strain_polynomial = {};
  }

  void read_curvature(const YamlReader& node, Segment& segment) const {
    if (node.has("curvature_per_unit") || unit_ != "1/m") {
      const YamlReader factor = node.at("curvature_per_unit");
      segment.curvature_per_unit = factor.number(fmt::format("1/m of curvature for 1 {}", unit_));
      factor.refuse_if(segment.curvature_per_unit == 0.0,
                       "0 found; expected another factor (negative where a positive command bends "
                       "right), or 'no_load: straight' for the arm");
    }
    const double limit = segment.pressure_limit_kpa.largest_kpa();
    const double turn_rad = std::abs(segment.curvature_per_unit) * limit * segment.length_m;
    const double max_rad = std::min(kMaxTurn_rad, segment.gaps * kMaxTurnOfGap_rad);
    if (!(turn_rad <= max_rad)) {
      node.refuse(
          fmt::format("the limit of {} {} would turn the segment by {:.3g} rad; expected "
                      "at most {:.4g}, {}",
                      limit, unit_, turn_rad, max_rad,
                      max_rad < kMaxTurn_rad ? "half a turn for its gap" : "a full turn"));
    }
  }

  static constexpr double kMaxTurn_rad = 2.0 * std::numbers::pi;
  static constexpr double kMaxTurnOfGap_rad = std::numbers::pi;  // no longer arc joins two plates
};

}  // namespace limber
