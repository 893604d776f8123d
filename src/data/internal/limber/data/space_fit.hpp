#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/recording.hpp"

namespace limber {

struct EpisodeErrors;

/// The simple model of an arm in space, docs/model.md (27): what commands were a dead time ago,
/// behind one first-order lag, bends and extends every segment in proportion to strains. It has no
/// memory of shapes, so no friction.
///
/// Sizes: n chambers, s segments.
struct SpaceFit {
  Eigen::MatrixXd shape;     ///< 3s × (n + 1): bend about y and z [rad], extension; constants last
  Eigen::MatrixXd shape_sd;  ///< of each, as the jackknife over ten pieces of the recordings says
  double dead_time_s = 0.0;
  double dead_time_sd_s = 0.0;  ///< likewise, with the lag as it is
  double lag_s = 0.0;
  std::vector<bool> is_held;  ///< n: chambers that never change, which do what the arm file says
  /// Mean distance of the plates behind the base, over the frames fitted to.
  double plates_mm = 0.0;
  double tip_mm = 0.0;
};

/// Fits it to the frames in which the arm was tracked. Robustly: frames count less the farther off
/// they are, so that a broken episode moves it little.
/// @throws InputError as require_episodes_of, or where too few frames were tracked.
SpaceFit fit_space_model(const ArmDescription& arm, const std::vector<Episode>& episodes);
bool is_enough_for_space_fit(const std::vector<Episode>& episodes);

/// How far each episode's tip is from where the model expects it. Nothing is said of turns: what
/// commands make of them is fitted, whatever it is.
EpisodeErrors episode_errors(const SpaceFit& model, const ArmDescription& arm,
                             const std::vector<Episode>& episodes);

/// Poses that the model expects under an episode's commands, T×7m, base at the origin.
FrameMatrix predict(const SpaceFit& fit, const ArmDescription& arm, const Episode& episode);

/// What a segment is long where no chamber acts.
struct SegmentAtRest {
  double length_m = 0.0;
  double length_sd_m = 0.0;
};
SegmentAtRest segment_at_rest(const SpaceFit& fit, const ArmDescription& arm, int segment);

/// The arm with the fit as its no-load model, `no_load: fitted`, and segments as long as they were
/// at rest; bends at rest are left out. Seven significant digits.
/// @throws InputError where a segment's length at rest is not positive.
ArmDescription with_space_fit(ArmDescription arm, const SpaceFit& fit);

/// What a chamber does to the segment that it is in, over all of its range, and what the arm file
/// says of that.
struct ChamberFinding {
  std::string name;        ///< "chamber 0 of segment 1"
  double bend_rad = 0.0;   ///< of its own segment
  double angle_deg = 0.0;  ///< toward which it bends it, from y toward z
  double extension = 0.0;  ///< share of the segment's length
  double sd_rad = 0.0;     ///< of the bend
  std::string suspicion;   ///< empty, or what is odd: "hardly acts", "bends to the other side" …
};
std::vector<ChamberFinding> chamber_findings(const ArmDescription& arm, const SpaceFit& fit);

Json to_json(const SpaceFit& fit, const ArmDescription& arm);
std::string to_text(const SpaceFit& fit, const ArmDescription& arm);

}  // namespace limber
