#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"

namespace limber {

struct EpisodeErrors;

/// One segment of the simple model: its turn is gain × the no-load model's + offset, its length
/// ratio × the no-load model's. Where the no-load model is straight, gain is in rad per unit of the
/// command.
struct SimpleSegment {
  double gain = 1.0;
  double offset_rad = 0.0;
  double length_ratio = 1.0;
};

/// What four numbers a segment make of commands (docs/model.md, (19)): arcs of constant curvature
/// behind one first-order lag. It has no memory of shapes, so no friction.
struct SimpleModel {
  std::vector<SimpleSegment> segments;
  double lag_s = 0.0;  ///< of every segment behind its command, ≥ 0
};

/// 95 % of what the fit would have given on other recordings like these.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// How sure a segment's numbers are.
struct SimpleSegmentFit {
  Interval gain;
  Interval offset_rad;
  Interval length_ratio;
  double residual_rad = 0.0;  ///< median |turn − model|
  double correlation = 0.0;   ///< of the turn with the model's
  bool moved = true;          ///< false: its command hardly changed, so its gain was left as it was
  /// Its length where its command is about zero, over the arm file's; none where that is rare.
  std::optional<double> rest_length_ratio;
};

struct SimpleFit {
  SimpleModel model;
  std::vector<SimpleSegmentFit> segments;
  int blocks = 0;  ///< pieces of the recordings that the intervals come from
};

/// Fits the simple model to the frames in which the arm was tracked. Robustly: Huber's weights, so
/// that a broken episode among good ones moves it little. Intervals are the jackknife's, leaving
/// out one episode at a time, or a tenth of a single one.
/// @throws InputError as require_episodes_of, or where no frame was tracked.
SimpleFit fit_simple_model(const ArmDescription& arm, const std::vector<Episode>& episodes);

/// The same, and `episode_errors`, of recordings whose numbers may be odd: those that are inspected
/// or imported. @pre finite numbers, sizes of the arm
SimpleFit fit_to_any(const ArmDescription& arm, const std::vector<Episode>& episodes);
EpisodeErrors errors_of_any(const ArmDescription& arm, const std::vector<Episode>& episodes);

/// The arm with the fit's gains and lengths in place of its own: strain polynomials times gain over
/// length ratio, or curvatures per unit; where its no-load model was straight, it is `curvature`
/// now. A length without a command that is over 2 % off the fitted one takes its place. Seven
/// significant digits. Offsets and the lag have no place in an arm file.
/// @throws InputError where a segment bends to the other side than the arm file says, or a
/// polynomial would reach a strain of 1.
ArmDescription with_simple_model(const ArmDescription& arm, const SimpleFit& fit);

/// The same for `fit_simple_model`, refined: a strain changes a segment's length too, so lengths
/// are fitted again to the arm that came out. @throws InputError as both.
ArmDescription fitted_arm(const ArmDescription& arm, const SimpleFit& fit,
                          const std::vector<Episode>& episodes);

/// A line in place of a missing strain polynomial, to be scaled by a fit: a fifth at the limit.
ArmDescription with_lines_for_missing_polynomials(ArmDescription arm);

Json to_json(const SimpleFit& fit);
std::string to_text(const SimpleFit& fit, const ArmDescription& arm);

/// Backbones that the model expects under an episode's commands, T×3m, base at the origin.
FrameMatrix predict(const SimpleModel& model, const ArmDescription& arm, const Episode& episode);

/// What each segment's no-load turn would be behind a lag, T×n [rad]; its command where the no-load
/// model is straight.
Eigen::MatrixXd lagged_turns(const ArmDescription& arm, const Episode& episode, double lag_s);

}  // namespace limber
