#include "limber/world/start_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"

namespace limber {

namespace {

constexpr double kReachAllowance = 1.2;  // a tracked arm may read a little longer than its file
constexpr double kBaseOffset_m = 0.01;   // of a tracked base plate; more is another frame
constexpr double kBaseHeading_rad = 0.1;
constexpr double kShortestGap = 0.5;    // plate to plate, over the gap's length at rest: both sides
constexpr double kLongestGap = 1.5;     // contracted and well bent; stretched by a pull
constexpr double kMaxOfFullBend = 2.0;  // a loaded segment does not bend evenly
constexpr double kUnevenTurn_rad = 0.5 * std::numbers::pi;  // of any arm's gap, pushed by hand
constexpr double kMaxTurn_rad = std::numbers::pi;  // beyond half a turn no arc joins two plates
// An arc's chord lies between its ends' headings; plates tilt by a few tenths.
constexpr double kMaxSkew_rad = 1.0;

/// Largest turn of one gap of a segment.
double turn_limit_rad(const ArmDescription& arm, const NoLoadModel& model, int segment) {
  if (arm.no_load == NoLoadKind::straight) {
    return kMaxTurn_rad;  // the arm file does not say how far it bends
  }
  const Segment& s = arm.segments[segment];
  const SegmentShape full = model.segment_shape(segment, s.pressure_limit_kpa.largest_kpa());
  return std::clamp(kMaxOfFullBend * std::abs(full.curvature_per_m) * full.length_m / s.gaps,
                    kUnevenTurn_rad, kMaxTurn_rad);
}

std::string reach_fault(const ArmDescription& arm, int row, double reach_m) {
  return fmt::format("{} is {:.4g} m from the base; the arm is {:.4g} m long (poses are in metres)",
                     plate_name(row), reach_m, arm.length_m());
}

std::string base_fault(const BackboneD& b) {
  if (std::hypot(b(0, 0), b(0, 1)) <= kBaseOffset_m && std::abs(b(0, 2)) <= kBaseHeading_rad) {
    return {};
  }
  return fmt::format(
      "plate 0 is at ({:.4g}, {:.4g}) m with heading {:.4g} rad; expected the base, (0, 0) m and "
      "0 rad, within {} m and {} rad: poses are in the base's frame",
      b(0, 0), b(0, 1), b(0, 2), kBaseOffset_m, kBaseHeading_rad);
}

/// Of the gap between plates `row` − 1 and `row`.
std::string gap_fault(const ArmDescription& arm, const NoLoadModel& model, const BackboneD& b,
                      int row) {
  const int segment = arm.segment_of_gap(row - 1);
  const Segment& s = arm.segments[segment];
  const double rest_m = s.length_m / s.gaps;
  const double x_m = b(row, 0) - b(row - 1, 0);
  const double y_m = b(row, 1) - b(row - 1, 1);
  const double apart_m = std::hypot(x_m, y_m);
  if (!(apart_m >= kShortestGap * rest_m && apart_m <= kLongestGap * rest_m)) {
    return fmt::format(
        "{} is {:.4g} m from {}; expected {:.4g} to {:.4g} m, {} to {} times the gap of {} at rest",
        plate_name(row), apart_m, plate_name(row - 1), kShortestGap * rest_m, kLongestGap * rest_m,
        kShortestGap, kLongestGap, segment_name(segment));
  }
  const double turn_rad = b(row, 2) - b(row - 1, 2);
  const double limit_rad = turn_limit_rad(arm, model, segment);
  if (!(std::abs(turn_rad) <= limit_rad)) {
    return fmt::format(
        "the heading turns by {:.4g} rad from {} to {}; expected at most {:.4g} rad in "
        "a gap of {} (headings are continuous, without jumps of a full turn)",
        turn_rad, plate_name(row - 1), plate_name(row), limit_rad, segment_name(segment));
  }
  const double skew_rad =
      std::remainder(std::atan2(y_m, x_m) - (b(row - 1, 2) + 0.5 * turn_rad), kMaxTurn_rad * 2.0);
  if (!(std::abs(skew_rad) <= kMaxSkew_rad)) {
    return fmt::format(
        "{} lies {:.4g} rad off where its heading and that of {} lead; expected at most {} rad",
        plate_name(row), skew_rad, plate_name(row - 1), kMaxSkew_rad);
  }
  return {};
}

}  // namespace

std::optional<StartFault> find_start_fault(const Backbone& backbone, const ArmDescription& arm) {
  if (backbone.rows() != arm.point_count()) {
    return StartFault{0, fmt::format("{} poses found; expected {}, one per plate of arm '{}'",
                                     backbone.rows(), arm.point_count(), arm.name)};
  }
  const BackboneD b = backbone.cast<double>();
  for (int row = 0; row < arm.point_count(); ++row) {
    const double reach_m = std::hypot(b(row, 0), b(row, 1));
    if (!(reach_m <= kReachAllowance * arm.length_m())) {
      return StartFault{row, reach_fault(arm, row, reach_m)};
    }
  }
  const NoLoadModel model(arm);
  for (int row = 0; row < arm.point_count(); ++row) {
    const std::string fault = row == 0 ? base_fault(b) : gap_fault(arm, model, b, row);
    if (!fault.empty()) {
      return StartFault{row, fault};
    }
  }
  return std::nullopt;
}

}  // namespace limber
