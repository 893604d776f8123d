#include "limber/data/simple_model.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

/// Commands behind a first-order lag that begins settled.
Eigen::MatrixXd lagged_commands(const Episode& episode, double lag_s) {
  Eigen::MatrixXd commands = episode.pressure_kpa.cast<double>();
  for (Eigen::Index t = 1; lag_s > 0.0 && t < commands.rows(); ++t) {
    const double step_s = episode.time_s[t] - episode.time_s[t - 1];
    const double share = 1.0 - std::exp(-step_s / lag_s);
    commands.row(t) =
        (1.0 - share) * commands.row(t - 1) + share * episode.pressure_kpa.row(t).cast<double>();
  }
  return commands;
}

constexpr int kRefinements = 2;
constexpr double kLineAtLimit = 0.2;  // strain; McKibben actuators in a segment reach about that

Json interval(const Interval& value) {
  if (!std::isfinite(value.low) || !std::isfinite(value.high)) {
    return nullptr;
  }
  return {value.low, value.high};
}

std::string with_interval(double value, const Interval& around) {
  return std::isfinite(around.low)
             ? fmt::format("{:.4g} ({:.4g} … {:.4g})", value, around.low, around.high)
             : fmt::format("{:.4g}", value);
}

/// @param length_ratio  the segment's length over the one that it has now
void set_shape(const ArmDescription& arm, double gain, double length_ratio, Segment& segment) {
  const double share = gain / length_ratio;
  switch (arm.no_load) {
    case NoLoadKind::strain_polynomial:
      for (double& coefficient : segment.strain_polynomial) {
        coefficient = seven_digits(share * coefficient);
      }
      break;
    case NoLoadKind::curvature:
      segment.curvature_per_unit = seven_digits(share * segment.curvature_per_unit);
      break;
    case NoLoadKind::straight:
      segment.curvature_per_unit = seven_digits(share / segment.length_m);
      break;
    case NoLoadKind::chambers:
    case NoLoadKind::fitted:
      break;  // of arms in space, which have another fit
  }
  segment.length_m = seven_digits(length_ratio * segment.length_m);
}

/// The fitted one, over all pressures; at rest alone where that is another: an arm that gets longer
/// under pressure has no place in the no-load model, which is to be right where plans start.
double written_length_ratio(const SimpleFit& fit, std::size_t segment) {
  constexpr double kAnother = 0.02;
  const double fitted = fit.model.segments[segment].length_ratio;
  const std::optional<double>& at_rest = fit.segments[segment].rest_length_ratio;
  return at_rest && std::abs(*at_rest - fitted) > kAnother * fitted ? *at_rest : fitted;
}

}  // namespace

Eigen::MatrixXd lagged_turns(const ArmDescription& arm, const Episode& episode, double lag_s) {
  Eigen::MatrixXd turns = lagged_commands(episode, lag_s);
  if (arm.no_load == NoLoadKind::straight) {
    return turns;
  }
  const NoLoadModel no_load(arm);
  for (int i = 0; i < arm.segment_count(); ++i) {
    for (double& value : turns.col(i)) {
      const SegmentShape shape = no_load.segment_shape(i, value);
      value = shape.curvature_per_m * shape.length_m;
    }
  }
  return turns;
}

FrameMatrix predict(const SimpleModel& model, const ArmDescription& arm, const Episode& episode) {
  const NoLoadModel no_load(arm);
  const Eigen::MatrixXd commands = lagged_commands(episode, model.lag_s);
  const Eigen::MatrixXd turns = lagged_turns(arm, episode, model.lag_s);
  FrameMatrix poses = FrameMatrix::Zero(episode.frame_count(), kPoseSize * arm.point_count());
  for (Eigen::Index t = 0; t < poses.rows(); ++t) {
    Pose pose;
    Eigen::Index column = kPoseSize;
    for (int i = 0; i < arm.segment_count(); ++i) {
      const SimpleSegment& segment = model.segments[i];
      const int gaps = arm.segments[i].gaps;
      const double turn_rad = (segment.gain * turns(t, i) + segment.offset_rad) / gaps;
      const double length_m = no_load.segment_shape(i, commands(t, i)).length_m;
      const Pose step = arc(segment.length_ratio * length_m / gaps, turn_rad);
      for (int gap = 0; gap < gaps; ++gap, column += kPoseSize) {
        pose = compose(pose, step);
        poses.row(t).segment<kPoseSize>(column) = numbers_of(pose).cast<float>();
      }
    }
  }
  return poses;
}

ArmDescription with_simple_model(const ArmDescription& arm, const SimpleFit& fit) {
  refuse_if(fit.model.segments.size() != arm.segments.size(),
            "a fit of {} segments; arm '{}' has {}. Fit it to recordings of this arm",
            fit.model.segments.size(), arm.name, arm.segment_count());
  ArmDescription fitted = arm;
  for (std::size_t i = 0; i < arm.segments.size(); ++i) {
    const SimpleSegment& model = fit.model.segments[i];
    const bool has_side = arm.no_load != NoLoadKind::straight;
    if (has_side && !(model.gain > 0.0)) {
      throw InputError(fmt::format(
          "{}: its turn is {:.3g} of what the arm file says, so it bends to the other side or not "
          "at all. Are columns and signs right? Import the logs again, and see what it says",
          segment_name(Eigen::Index(i)), model.gain));
    }
    if (!has_side && !fit.segments[i].moved) {
      throw InputError(fmt::format(
          "{}: its {} hardly changes in these recordings, so nothing is known of its curvature",
          segment_name(Eigen::Index(i)), arm.command.name));
    }
    set_shape(arm, model.gain, written_length_ratio(fit, i), fitted.segments[i]);
    const std::string fault = arm.no_load == NoLoadKind::strain_polynomial
                                  ? why_unusable(fitted.segments[i].strain_polynomial,
                                                 arm.segments[i].pressure_limit_kpa.largest_kpa())
                                  : std::string();
    if (!fault.empty()) {
      throw InputError(
          fmt::format("{}: the fitted strain polynomial {}", segment_name(Eigen::Index(i)), fault));
    }
  }
  if (arm.no_load == NoLoadKind::straight) {
    fitted.no_load = NoLoadKind::curvature;
  }
  return fitted;
}

ArmDescription fitted_arm(const ArmDescription& arm, const SimpleFit& fit,
                          const std::vector<Episode>& episodes) {
  ArmDescription fitted = with_simple_model(arm, fit);
  for (int round = 0; round < kRefinements; ++round) {
    fitted = with_simple_model(fitted, fit_simple_model(fitted, episodes));
  }
  return fitted;
}

ArmDescription with_lines_for_missing_polynomials(ArmDescription arm) {
  for (Segment& segment : arm.segments) {
    if (arm.no_load == NoLoadKind::strain_polynomial &&
        segment.strain_polynomial == StrainPolynomial{}) {
      segment.strain_polynomial = {kLineAtLimit / segment.pressure_limit_kpa.largest_kpa(), 0.0,
                                   0.0, 0.0};
    }
  }
  return arm;
}

Json to_json(const SimpleFit& fit) {
  Json json;
  json["lag_s"] = fit.model.lag_s;
  json["blocks"] = fit.blocks;
  json["segments"] = Json::array();
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const SimpleSegment& model = fit.model.segments[i];
    const SimpleSegmentFit& found = fit.segments[i];
    json["segments"].push_back({{"gain", model.gain},
                                {"gain_interval", interval(found.gain)},
                                {"offset_rad", model.offset_rad},
                                {"offset_interval_rad", interval(found.offset_rad)},
                                {"length_ratio", model.length_ratio},
                                {"length_ratio_interval", interval(found.length_ratio)},
                                {"residual_rad", found.residual_rad},
                                {"correlation", found.correlation},
                                {"moved", found.moved}});
  }
  return json;
}

std::string to_text(const SimpleFit& fit, const ArmDescription& arm) {
  const bool straight = arm.no_load == NoLoadKind::straight;
  std::string text =
      fmt::format("the arm follows its {}s by {:.2f} s\n", arm.command.name, fit.model.lag_s);
  for (std::size_t i = 0; i < fit.segments.size(); ++i) {
    const SimpleSegment& model = fit.model.segments[i];
    const SimpleSegmentFit& found = fit.segments[i];
    text += fmt::format(
        "{}: turns {} {}, {} rad beside; length {} of the no-load model's; median residual {:.3f} "
        "rad, correlation {:.2f}{}\n",
        segment_name(Eigen::Index(i)), with_interval(model.gain, found.gain),
        straight ? "rad/" + arm.command.unit : "of what the arm file says",
        with_interval(model.offset_rad, found.offset_rad),
        with_interval(model.length_ratio, found.length_ratio), found.residual_rad,
        found.correlation, found.moved ? "" : "; it hardly moved, so its gain stays as it was");
  }
  return text + "in brackets: 95 % intervals";
}

}  // namespace limber
